(* ---------------------------------------------------------------------------------------------
   Without position: every world that has a cycle has a twin.                           Section III

   Take two copies of the world and cut an edge e in both; join each cut end to the other end in
   the other copy.  If e lies on a cycle, the result is one connected world, twice as large, and a
   robot without position cannot tell it from the world itself, even with a compass at every
   vertex.

     crosses d                d is an end of e.
     on_cycle e               the ends of e are joined by steps that do not use e.
     double_cover             the world so built: its darts are (dart, copy).
     degree_sensed            the percept without information: the degree.
     compass ref d            the percept with orientation only: the degree, and the bearing to
                              the reference dart (the darts of ref, one at each vertex).
     world_with_cycle_impossible   no explorer finds the maps of both.
     cover_simple             in a simple world both are simple.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Explorers Indistinguishable.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Cover.
Variables (G : combinatorial_map) (e : G).
Implicit Types (d x y : G) (t u : bool).

Definition crosses d := (d == e) || (d == alpha e).
Definition step_without_e : rel G := fun x y => (y == sigma x) || ((y == alpha x) && ~~ crosses x).
Definition on_cycle := connect step_without_e (alpha e) e.

Lemma crosses_alpha d : crosses (alpha d) = crosses d.
Proof. by rewrite /crosses orbC -{2}[e]alphaK !(inj_eq (@alpha_inj G)). Qed.

Hypothesis cycle : on_cycle.

Definition cover_sigma (p : G * bool) := (sigma p.1, p.2).
Definition cover_alpha (p : G * bool) := (alpha p.1, p.2 (+) crosses p.1).

Lemma cover_sigma_inj : injective cover_sigma.
Proof. by move=> [x t] [y u] [/sigma_inj -> ->]. Qed.

Lemma cover_alphaK : involutive cover_alpha.
Proof. by move=> [x t]; rewrite /cover_alpha /= alphaK crosses_alpha addbK. Qed.

Lemma cover_alpha_neq p : cover_alpha p != p.
Proof. by case: p => x t; apply/eqP=> -[E _]; have := alpha_neq x; rewrite E eqxx. Qed.

Lemma cover_connected p q : connect (adjacent cover_sigma cover_alpha) p q.
Proof.
set adj := adjacent _ _; have sym := adjacent_connect_sym cover_sigma_inj cover_alphaK.
have one_sigma x t : connect adj (x, t) (sigma x, t).
  by apply: connect1; rewrite /adj /adjacent eqxx.
have one_alpha x t : connect adj (x, t) (alpha x, t (+) crosses x).
  by apply: connect1; rewrite /adj /adjacent /cover_alpha eqxx orbT.
have lift x t : exists u, connect adj (x, t) (e, u).
  case/connectP: (connected_map x e) => s; elim: s x t => [|y s IH] x t /=.
    by move=> _ ->; exists t.
  case/andP=> /orP[]/eqP-> P L.
    by have [u H] := IH _ t P L; exists u; apply: connect_trans H.
  by have [u H] := IH _ (t (+) crosses x) P L; exists u; apply: connect_trans H.
have same_copy x y t : connect step_without_e x y -> connect adj (x, t) (y, t).
  case/connectP=> s; elim: s x => [|z s IH] x /=; first by move=> _ ->.
  case/andP=> S P L; apply: connect_trans (IH _ P L); case/orP: S => [/eqP->|/andP[/eqP-> N]] //.
  by have := one_alpha x t; rewrite (negbTE N) addbF.
have other_copy t : connect adj (e, t) (e, ~~ t).
  apply: connect_trans (one_alpha e t) _; rewrite /crosses eqxx addbT; exact: same_copy.
case: p q => [x t] [y u]; have [t' H] := lift x t; have [u' H'] := lift y u.
apply: connect_trans H _; rewrite sym; apply: connect_trans H' _.
case: (eqVneq u' t') => [->|ne]; first exact: connect0.
have -> : t' = ~~ u' by case: (t') (u') ne => -[].
exact: other_copy.
Qed.

Definition double_cover :=
  @CombinatorialMap [finType of (G * bool)] _ _
    cover_sigma_inj cover_alphaK cover_alpha_neq cover_connected.

Lemma turn_in_cover k d t : iter k (@sigma double_cover) (d, t) = (iter k sigma d, t).
Proof. by elim: k => //= k ->. Qed.

(* the robot senses the same degree in the cover *)
Lemma degree_in_cover d t : @degree double_cover (d, t) = degree d.
Proof.
rewrite /degree /order -(card_image (f := fun x : G => (x, t))); last by move=> x y [].
apply: eq_card => q; rewrite -topredE /=; apply/idP/imageP=> [c|[y c ->]].
  exists q.1; last by rewrite -(iter_findex c) turn_in_cover.
  by rewrite -(iter_findex c) turn_in_cover /=; exact: fconnect_iter.
have <- := iter_findex c; rewrite -turn_in_cover; exact: fconnect_iter.
Qed.
End Cover.

Definition degree_sensed (G : combinatorial_map) (d : G) := degree d.
Definition compass (G : combinatorial_map) (ref : pred G) (d : G) :=
  (degree d, find (fun k => ref (iter k sigma d)) (iota 0 (degree d))).

Section Impossible.
Variables (G : combinatorial_map) (e : G).
Hypothesis cycle : on_cycle e.
Local Notation H := (double_cover cycle).

Lemma compass_in_cover (ref : pred G) d t :
  @compass H (fun p => ref p.1) (d, t) = compass ref d.
Proof.
rewrite /compass degree_in_cover; congr (_, _); apply: eq_find => k.
by rewrite turn_in_cover.
Qed.

Section Explorer.
Variables (P : Type) (senses : G -> P) (senses' : H -> P) (start : G).
Hypothesis same : forall d t, senses' (d, t) = senses d.

Theorem cover_same_episode E (X : explorer P E) budget :
  (episode X (rooted start) senses budget).1
  = (episode X (rooted ((start, false) : H)) senses' budget).1.
Proof.
apply: (@twins_episode _ _ X (rooted start) (rooted ((start, false) : H)) senses senses'
  (fun x y => x = y.1)) => //= x [y t] /= ->; rewrite ?same //.
Qed.

Lemma cover_edges : edges H = (edges G).*2.
Proof. by apply: double_inj; rewrite !edges_double card_prod card_bool muln2 -edges_double. Qed.

Lemma cover_impossible :
  @no_explorer_finds_both P (rooted start) (rooted ((start, false) : H)) senses senses'.
Proof.
move=> E meaning X [F1 F2].
have /same_map_edges : same_map (rooted start) (rooted ((start, false) : H)).
  apply: (@twins_same_map _ _ meaning X (rooted start) (rooted ((start, false) : H)) senses senses'
    (fun x y => x = y.1)) F1 F2 => //; last exact: rooted_wellformed.
  - by move=> x [y t] /= ->; rewrite same.
  - by move=> x [y t] /= ->.
  - by move=> x [y t] /= ->.
rewrite cover_edges -addnn -{1}[edges G]addn0 => /addnI /esym e0.
by have := edges_gt0 start; rewrite e0.
Qed.
End Explorer.

(* in a simple world it is a simple world that cannot be told apart *)
Lemma cover_simple : simple_world G -> simple_world H.
Proof.
have at_vertex (x y : H) : at_same_vertex x y -> at_same_vertex x.1 y.1 /\ x.2 = y.2.
  by case: x => d t /iter_findex <-; rewrite turn_in_cover; split=> //; exact: fconnect_iter.
move=> S x y /at_vertex[v E] /at_vertex[v' _].
by rewrite (surjective_pairing x) (surjective_pairing y) E (S _ _ v v').
Qed.

Theorem world_with_cycle_impossible (start : G) (ref : pred G) :
  @no_explorer_finds_both nat (rooted start) (rooted ((start, false) : H))
    (@degree_sensed G) (@degree_sensed H) /\
  @no_explorer_finds_both (nat * nat) (rooted start) (rooted ((start, false) : H))
    (compass ref) (@compass H (fun p => ref p.1)).
Proof.
split; apply: cover_impossible => d t; first exact: degree_in_cover.
exact: compass_in_cover.
Qed.
End Impossible.

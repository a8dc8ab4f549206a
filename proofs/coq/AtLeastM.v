(* ---------------------------------------------------------------------------------------------
   A lower bound for every explorer: at least m motions.                              Section VI

   An explorer that never crosses the edge e behaves the same where e carries one more vertex, of
   degree 2.  So if it is right in both worlds it must cross every edge, and one motion crosses
   one edge.

     subdivided e             the world with a vertex of degree 2 on the edge of e: its darts are
                              those of G (inl) and two new ones (inr).
     avoids e w d             the motions w from d never cross e.
     sense_subdivided         the percepts there: as before, and new c in the two new darts.
     at_least_m               right here, and in every world so made from this one: at least m
                              motions.
     directional_at_least_m   so an explorer that is right in all worlds with a directional
                              lighthouse makes at least m motions in each.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Subdivide.
Variables (G : combinatorial_map) (e : G).

Definition sub_sigma (x : G + bool) : G + bool :=
  match x with inl d => inl (sigma d) | inr c => inr (~~ c) end.
Definition sub_alpha (x : G + bool) : G + bool :=
  match x with
  | inl d => if d == e then inr false else if d == alpha e then inr true else inl (alpha d)
  | inr c => inl (if c then alpha e else e)
  end.

Lemma sub_sigma_inj : injective sub_sigma.
Proof. by move=> [x|c] [y|d] //= [] => [/sigma_inj->|/negb_inj->]. Qed.

Lemma sub_alphaK : involutive sub_alpha.
Proof.
move=> [x|[]] /=; last by rewrite eqxx.
  case: (x =P e) => [->//|xe]; case: (x =P alpha e) => [->//|xae] /=.
  have -> : (alpha x == e) = false by apply/eqP=> E; apply: xae; rewrite -E alphaK.
  have -> : (alpha x == alpha e) = false by apply/eqP=> /(@alpha_inj G).
  by rewrite alphaK.
by rewrite (negbTE (alpha_neq e)) eqxx.
Qed.

Lemma sub_alpha_neq x : sub_alpha x != x.
Proof.
apply/eqP; case: x => [x|[]] //=; case: (x =P e) => // _; case: (x =P alpha e) => // _ [E].
by move: (alpha_neq x); rewrite E eqxx.
Qed.

Lemma sub_connected x y : connect (adjacent sub_sigma sub_alpha) x y.
Proof.
set adj := adjacent _ _; have sym := adjacent_connect_sym sub_sigma_inj sub_alphaK.
have one_alpha z : connect adj z (sub_alpha z) by apply: connect1; rewrite /adj /adjacent eqxx orbT.
have one_sigma z : connect adj z (sub_sigma z) by apply: connect1; rewrite /adj /adjacent eqxx.
have across : connect adj (inl e) (inl (alpha e)).
  have := one_alpha (inl e); rewrite /= eqxx => H.
  apply: connect_trans H (connect_trans (one_sigma (inr false)) (one_alpha (inr true))).
have old u v : connect adj (inl u) (inl v).
  move: v; apply: (@everywhere G (fun v => connect adj (inl u) (inl v)) u) => [|v H|v H];
    first exact: connect0.
    exact: connect_trans H (one_sigma (inl v)).
  apply: connect_trans H _; have := one_alpha (inl v); rewrite /=.
  case: eqP => [-> _|_]; first exact: across.
  by case: eqP => [-> _|_] //; rewrite alphaK sym; exact: across.
have to_old z : connect adj z (inl e).
  case: z => [u|c]; first exact: old.
  exact: connect_trans (one_alpha (inr c)) (old (if c then alpha e else e) e).
by apply: connect_trans (to_old x) _; rewrite sym.
Qed.

Definition subdivided :=
  @CombinatorialMap [finType of (G + bool)] _ _ sub_sigma_inj sub_alphaK sub_alpha_neq sub_connected.

Lemma turn_subdivided k (d : G) : iter k (@sigma subdivided) (inl d) = inl (iter k sigma d).
Proof. by elim: k => //= k ->. Qed.

(* ---- An explorer that does not cross e notices nothing ---- *)
Fixpoint avoids w (d : G) :=
  if w is k :: w' then
    let x := iter k sigma d in [&& x != e, x != alpha e & avoids w' (alpha x)]
  else true.

Section Explorer.
Variables (P E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (senses : G -> P) (new : bool -> P) (r : G).

Definition sense_subdivided (x : subdivided) := match x with inl d => senses d | inr c => new c end.
Local Notation here := (rooted r).
Local Notation there := (rooted (inl r : subdivided)).

Lemma explore_subdivided budget h d t a z :
  explore X here senses budget h d = (t, a, z) -> avoids (unzip1 t) d ->
  explore X there sense_subdivided budget h (inl d) = (t, a, inl z).
Proof.
elim: budget h d t => [|fl IH] h d t /=; first by case: (X h) => [k|a'] [<- <- <-].
case: (X h) => [k|a']; last by case=> <- <- <-.
case R: (explore _ _ _ _ _ _) => [[t1 a1] z1] /= [<- aa zz] /= /and3P[n1 n2 A]; subst a1 z1.
have -> : sub_alpha (iter k sub_sigma (inl d)) = inl (alpha (iter k sigma d)).
  by rewrite (turn_subdivided k d) /= (negbTE n1) (negbTE n2).
by rewrite /= (IH _ _ _ R A).
Qed.

Lemma subdivided_differs (x : G) (y : subdivided) : ~ isomorphic (rooted x) (rooted y).
Proof.
case=> f [g [_ G' _]]; have gi : injective g.
  by move=> u v E'; have [_ <-] := G' u isT; have [_ <-] := G' v isT; rewrite E'.
by have := leq_card g gi; rewrite card_sum card_bool leqNgt -{1}[#|G|]addn0 ltn_add2l.
Qed.

Theorem uncrossed_wrong budget t a z : episode X here senses budget = (t, Some a, z) ->
  avoids (unzip1 t) r -> wellformed (meaning a) -> isomorphic (meaning a) (rooted z) ->
  ~ right meaning X there sense_subdivided.
Proof.
move=> Ep A Wa Ia [f2 [t2 [a2 [z2 [E2 W2 I2]]]]].
have E1 := explore_more f2 (explore_subdivided Ep A).
have E2' := explore_more budget E2; rewrite addnC E1 in E2'; case: E2' => _ aa zz; subst a2 z2.
exact: (subdivided_differs (isomorphic_trans (isomorphic_sym Wa Ia) I2)).
Qed.
End Explorer.
End Subdivide.

(* ---- Counting the edges crossed ---- *)
Section LowerBound.
Variables (P E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (G : combinatorial_map) (senses : G -> P) (r : G).

Fixpoint crossed w (d : G) : seq G :=
  if w is k :: w' then let x := iter k sigma d in [:: x, alpha x & crossed w' (alpha x)] else [::].

Lemma avoidsE (e : G) w d : avoids e w d = (e \notin crossed w d).
Proof.
elim: w d => //= k w IH d; rewrite IH !inE !negb_or eq_sym; congr (_ && (_ && _)).
by rewrite -(inj_eq (@alpha_inj G) _ (alpha e)) alphaK eq_sym.
Qed.

Theorem at_least_m budget t a z : episode X (rooted r) senses budget = (t, Some a, z) ->
  wellformed (meaning a) -> isomorphic (meaning a) (rooted z) ->
  (forall e : G, exists new,
     right meaning X (rooted (inl r : subdivided e)) (@sense_subdivided G e P senses new)) ->
  edges G <= size t.
Proof.
move=> Ep Wa Ia H; have sz w d : size (crossed w d) = (size w).*2.
  by elim: w d => //= k w IH d; rewrite IH.
rewrite -leq_double edges_double -(size_map fst) -(sz _ r).
apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> e _.
apply/negPn/negP=> ne; have [new Rt] := H e.
by apply: (uncrossed_wrong Ep _ Wa Ia Rt); rewrite avoidsE.
Qed.
End LowerBound.

(* ---- The subdivided world has a directional lighthouse too ---- *)
Section Directional.
Variables (W : lighthouse_world) (e : W).
Local Notation H := (subdivided e).

Lemma vertex_subdivided (d : W) (y : H) :
  at_same_vertex (inl d : H) y = if y is inl d' then at_same_vertex d d' else false.
Proof.
apply/idP/idP=> [c|].
  by rewrite -(iter_findex c) turn_subdivided; exact: fconnect_iter.
by case: y => // d' c; rewrite -(iter_findex c) -turn_subdivided; exact: fconnect_iter.
Qed.

Lemma degree_subdivided (d : W) : degree (inl d : H) = degree d.
Proof.
rewrite /degree /order -(card_image (f := @inl W bool)); last by move=> x y [].
apply: eq_card => y; rewrite -topredE /=; have := vertex_subdivided d y; rewrite /at_same_vertex => ->.
by apply/idP/imageP=> [|[d' c ->]] //; case: y => // d' c; exists d'.
Qed.

Lemma degree_new c : degree (inr c : H) = 2.
Proof.
have U : uniq [:: inr c; inr (~~ c) : H] by case: (c).
rewrite /degree (order_cycle _ U (mem_head _ _)) //= /frel /= negbK !eqxx.
by [].
Qed.

Definition subdivided_world : lighthouse_world :=
  @LighthouseWorld H (inl start) (inl pointed)
    (etrans (vertex_subdivided _ (inl pointed)) (@pointed_at_v0 W)).

Lemma percept_subdivided (x : subdivided_world) :
  percept_of x = @sense_subdivided W e _ (@percept_of W) (fun _ => (2, None)) x.
Proof.
rewrite /percept_of /bearing; case: x => [d|c] /=; last first.
  by rewrite degree_new at_same_vertex_sym vertex_subdivided.
rewrite degree_subdivided vertex_subdivided; case: ifP => // c; congr (_, Some _).
rewrite -{1}(iter_findex c) -(@turn_subdivided W e) findex_iter //.
by have := degree_subdivided d; rewrite /degree => ->; exact: findex_max.
Qed.
End Directional.

Theorem directional_at_least_m E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W)) ->
  forall W : lighthouse_world, exists budget t a z,
    episode X (rooted (@start W)) (@percept_of W) budget = (t, Some a, z) /\ edges W <= size t.
Proof.
move=> R W; have [f [t [a [z [Ep Wa Ia]]]]] := R W.
exists f, t, a, z; split=> //; apply: (at_least_m Ep Wa Ia) => e; exists (fun _ => (2, None)).
have [f2 [t2 [a2 [z2 [E2 W2 I2]]]]] := R (subdivided_world e).
exists f2, t2, a2, z2; split=> //; rewrite -E2 /episode -percept_subdivided.
by apply: explore_ext => x; rewrite -percept_subdivided.
Qed.

(* ---------------------------------------------------------------------------------------------
   Covers with two sheets, the marker in one of them.                                  Section VI

   Colour edges; two copies of the world, with every coloured edge led over into the other copy, are a
   world of twice the size, provided that the coloured edges are not all the edges between some vertices
   and the others.  Mark v0 in one copy only.  Where the robot has come back to v0 each time after an
   even number of crossings of coloured edges, it has sensed nothing that tells the two worlds apart.

     voltage_world c      the world of two copies, for a colouring c; its darts are (dart, copy).
     quiet c w d b        the motions w from d, begun in copy b, enter v0 in the first copy only.
     voltage_in_universe  the cover of a simple world is simple.
     upper c              what is reached in the second copy; disconnected_potential: if the copies are
                          not connected, c separates the vertices of upper from the others.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Log.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section VoltageCover.
Variables (W : lighthouse_world) (c : W -> bool).
Hypothesis c_sym : forall d, c (alpha d) = c d.

Definition voltage_sigma (x : W * bool) := (sigma x.1, x.2).
Definition voltage_alpha (x : W * bool) := (alpha x.1, x.2 (+) c x.1).
Definition flip (x : W * bool) := (x.1, ~~ x.2).
Local Notation reach := (connect (adjacent voltage_sigma voltage_alpha)).
Local Notation v0 := (@start W).

Lemma voltage_sigma_inj : injective voltage_sigma.
Proof. by move=> [x b] [y b'] [/sigma_inj -> ->]. Qed.

Lemma voltage_alphaK : involutive voltage_alpha.
Proof. by move=> [x b]; rewrite /voltage_alpha /= alphaK c_sym -addbA addbb addbF. Qed.

Lemma voltage_alpha_neq x : voltage_alpha x != x.
Proof. by case: x => x b; apply/eqP=> -[]; have /eqP := alpha_neq x. Qed.

Lemma reach_sigma x : reach x (voltage_sigma x).
Proof. by apply: connect1; rewrite /adjacent eqxx. Qed.

Lemma reach_alpha x : reach x (voltage_alpha x).
Proof. by apply: connect1; rewrite /adjacent eqxx orbT. Qed.

Lemma reach_sym x y : reach x y -> reach y x.
Proof.
by rewrite (adjacent_connect_sym voltage_sigma_inj voltage_alphaK).
Qed.

Lemma reach_flip x y : reach x y -> reach (flip x) (flip y).
Proof.
case/connectP=> p + ->; elim: p x => //= z p IH x /andP[H /IH]; apply: connect_trans.
case/orP: H => /eqP->; first exact: reach_sigma (flip x).
by have := reach_alpha (flip x); rewrite /voltage_alpha /flip /= addNb.
Qed.

Lemma reach_one d : exists b, reach (v0, false) (d, b).
Proof.
move: d; apply: (@everywhere W _ v0) => [|x [b H]|x [b H]]; first by exists false.
  by exists b; apply: connect_trans H (reach_sigma (x, b)).
by exists (b (+) c x); apply: connect_trans H (reach_alpha (x, b)).
Qed.

(* c tells apart what a potential on the vertices does not *)
Definition upper := [set r in froots (@sigma W) | reach (v0, false) (r, true)].

Lemma upperE d : (froot sigma d \in upper) = reach (v0, false) (d, true).
Proof.
have H : fconnect sigma d (froot sigma d) by exact: connect_root.
have K : reach (d, true) (froot sigma d, true).
  rewrite -(iter_findex H); elim: (findex _ _ _) => //= k IH.
  exact: connect_trans IH (reach_sigma (iter k sigma d, true)).
have r : froot sigma d \in froots (@sigma W) by exact: (roots_root (fconnect_sym (@sigma_inj W))).
by rewrite inE r; apply/idP/idP=> R; [apply: connect_trans R (reach_sym K)
  | exact: connect_trans R K].
Qed.

Lemma disconnected_potential : ~~ reach (v0, false) (v0, true) ->
  froot sigma v0 \notin upper /\
  forall d, c d = (froot sigma d \in upper) (+) (froot sigma (alpha d) \in upper).
Proof.
move=> N; have one d : reach (v0, false) (d, false) = ~~ reach (v0, false) (d, true).
  apply/idP/idP=> H; last first.
    by have [[] R] := reach_one d; [rewrite R in H | exact: R].
  apply: contra N => K; apply: connect_trans K _; apply: reach_sym; exact: (reach_flip H).
have bit d b : reach (v0, false) (d, b) -> reach (v0, false) (d, true) = b.
  by case: b => // R; apply/negbTE; rewrite -one.
split=> [|d]; first by rewrite upperE.
rewrite !upperE; have [b R] := reach_one d; rewrite (bit _ _ R).
rewrite (bit _ (b (+) c d)); first by rewrite addbA addbb.
exact: connect_trans R (reach_alpha (d, b)).
Qed.

Hypothesis sheets : reach (v0, false) (v0, true).

Lemma voltage_connected x y : reach x y.
Proof.
have H z : reach (v0, false) z.
  case: z => d b; have [b' R] := reach_one d; case: (b =P b') => [->//|ne].
  apply: connect_trans sheets _; have -> : (d, b) = flip (d, b') by move: ne; case: (b); case: (b').
  exact: (reach_flip R).
exact: connect_trans (reach_sym (H x)) (H y).
Qed.

Definition voltage_cover := CombinatorialMap voltage_sigma_inj voltage_alphaK voltage_alpha_neq
  voltage_connected.

Lemma voltage_turn k d b : iter k (@sigma voltage_cover) (d, b) = (iter k sigma d, b).
Proof. by elim: k => //= k ->. Qed.

Lemma voltage_pointed : @at_same_vertex voltage_cover (v0, false) (pointed, false).
Proof.
have <- : iter (findex sigma v0 pointed) (@sigma voltage_cover) (v0, false) = (@pointed W, false).
  by rewrite voltage_turn iter_findex //; exact: pointed_at_v0.
exact: fconnect_iter.
Qed.

(* only the vertex over v0 in the lower sheet is marked *)
Definition voltage_world := @LighthouseWorld voltage_cover (v0, false) (pointed, false)
  voltage_pointed.

Lemma voltage_percept d b : (at_same_vertex v0 d -> b = false) ->
  percept_of ((d, b) : voltage_world) = percept_of d.
Proof.
move=> H; apply: percept_transfer => j; rewrite voltage_turn; first by rewrite xpair_eqE eqxx andbT.
rewrite xpair_eqE; case: (iter j sigma d =P pointed) => //= E; rewrite H // .
apply: connect_trans (@pointed_at_v0 W) _.
by rewrite -/(at_same_vertex _ _) at_same_vertex_sym -E; exact: fconnect_iter.
Qed.

(* the sheets in which v0 is entered *)
Fixpoint quiet w (d : W) b :=
  if w is k :: w' then
    let d' := motion k d in let b' := b (+) c (iter k sigma d) in
    (at_same_vertex v0 d' ==> ~~ b') && quiet w' d' b'
  else true.

Lemma quiet_percepts w d b : (at_same_vertex v0 d -> b = false) -> quiet w d b ->
  percepts_along w ((d, b) : voltage_world) = percepts_along w d.
Proof.
elim: w d b => [|k w IH] d b H /=; first by rewrite voltage_percept.
case/andP=> /implyP Q R; rewrite voltage_percept //; congr (_ :: _).
by rewrite /motion voltage_turn IH // => /Q/negbTE.
Qed.

Lemma quiet_agrees t : agrees W (log_of W t) -> quiet (unzip1 t) v0 false ->
  agrees voltage_world (log_of W t).
Proof. by rewrite /agrees => <- Q; exact: quiet_percepts. Qed.

Lemma voltage_edges : edges voltage_world = (edges W).*2.
Proof. by apply: double_inj; rewrite !edges_double card_prod card_bool muln2 -edges_double. Qed.

Lemma voltage_not_same_map : ~ same_map (rooted v0) (rooted (@start voltage_world)).
Proof.
move/same_map_edges; rewrite voltage_edges -addnn -{1}[edges W]addn0 => /addnI /esym e0.
by have := edges_gt0 v0; rewrite e0.
Qed.

Lemma voltage_same_vertex (x y : voltage_world) : at_same_vertex x y ->
  at_same_vertex x.1 y.1 /\ x.2 = y.2.
Proof. by case: x => d b /iter_findex <-; rewrite voltage_turn; split=> //; exact: fconnect_iter. Qed.

Lemma voltage_in_universe u : in_universe u W -> in_universe u voltage_world.
Proof.
case: u => // S x y /voltage_same_vertex[v E] /voltage_same_vertex[v' _].
by rewrite (surjective_pairing x) (surjective_pairing y) E (S _ _ v v').
Qed.
End VoltageCover.


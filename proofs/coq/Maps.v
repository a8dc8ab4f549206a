(* ---------------------------------------------------------------------------------------------
   Maps, motions, reversibility.                                                  Sections II.A, II.B

     motions_undone       motions are undone by as many motions and a turn; a last turn is free.
     everywhere           what holds of one dart and is kept by sigma and alpha holds of all.
     automorphism_rigid   an automorphism that fixes a dart is the identity.
     edges_double         2m darts.
     opposite n k         turning by it takes back a turn by k at a vertex of degree n.

   One law does most of the work: walk_inj, a fixed list of motions leads different darts to
   different darts.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* such steps can be taken back: sigma has finite order, alpha is its own inverse *)
Lemma adjacent_connect_sym (D : finType) (sigma alpha : D -> D) :
  injective sigma -> involutive alpha -> connect_sym (adjacent sigma alpha).
Proof.
move=> inj aK; set adj := adjacent _ _; have step z u : adj z u -> connect adj u z.
  case/orP=> /eqP->; last by apply: connect1; rewrite /adj /adjacent aK eqxx orbT.
  have : fconnect sigma (sigma z) z by rewrite (fconnect_sym inj) fconnect1.
  by apply: connect_sub => a c /eqP <-; apply: connect1; rewrite /adj /adjacent eqxx.
suff half z u : connect adj z u -> connect adj u z by move=> z u; apply/idP/idP; exact: half.
case/connectP=> p P ->; elim: p z P => [|a p IH] z /=; first by rewrite connect0.
by case/andP=> /step S /IH H; exact: connect_trans H S.
Qed.

Section Motions.
Variable G : combinatorial_map.
Implicit Types (d x y : G) (w : seq nat) (k : nat).

(* ---- Motions are reversible ---- *)
Lemma alpha_inj : injective (@alpha G).
Proof. exact: inv_inj alphaK. Qed.

Lemma iter_sigma_inj k : injective (iter k (@sigma G)).
Proof. by elim: k => [|k IH] x y //= /sigma_inj /IH. Qed.

Lemma motion_inj k : injective (@motion G k).
Proof. by move=> x y /alpha_inj /iter_sigma_inj. Qed.

(* where a list of motions ends determines where it began *)
Theorem walk_inj w : injective (@walk G w).
Proof. by elim: w => [|k w IH] x y //= /IH /motion_inj. Qed.

(* ---- Connectedness ---- *)

(* what holds of one dart and is kept by sigma and alpha holds of all *)
Lemma everywhere (A : G -> Prop) d :
  A d -> (forall x, A x -> A (sigma x)) -> (forall x, A x -> A (alpha x)) -> forall x, A x.
Proof.
move=> Ad As Aa x; case/connectP: (connected_map d x) => p + ->.
by elim: p d Ad => //= y p IH d Ad /andP[/orP[]/eqP-> {y}]; apply: IH; auto.
Qed.

(* two morphisms that agree on one dart agree *)
Lemma morphisms_agree (E : Type) (sigmaE alphaE : E -> E) (f g : G -> E) d :
  (forall x, f (sigma x) = sigmaE (f x)) -> (forall x, f (alpha x) = alphaE (f x)) ->
  (forall x, g (sigma x) = sigmaE (g x)) -> (forall x, g (alpha x) = alphaE (g x)) ->
  f d = g d -> f =1 g.
Proof.
by move=> fs fa gs ga fgd; apply: (everywhere fgd) => x fgx; rewrite ?fs ?gs ?fa ?ga fgx.
Qed.

Corollary automorphism_rigid (f : G -> G) d :
  (forall x, f (sigma x) = sigma (f x)) -> (forall x, f (alpha x) = alpha (f x)) ->
  f d = d -> f =1 id.
Proof. by move=> fs fa fd; apply: (@morphisms_agree G sigma alpha f id d). Qed.

(* ---- Turning ---- *)
Lemma at_same_vertex_sym x y : at_same_vertex x y = at_same_vertex y x.
Proof. exact: (fconnect_sym sigma_inj). Qed.

Lemma degree_same x y : at_same_vertex x y -> degree y = degree x.
Proof.
move=> c; rewrite /degree /order; apply: eq_card => z.
by rewrite -!topredE /= (same_connect (fconnect_sym sigma_inj) c).
Qed.

Lemma degree_gt0 d : 0 < degree d.
Proof. exact: order_gt0. Qed.

Lemma iter_degree d : iter (degree d) sigma d = d.
Proof. exact: (iter_order sigma_inj). Qed.

Lemma turn_modulo_degree k d : iter (k %% degree d) sigma d = iter k sigma d.
Proof.
rewrite [in RHS](divn_eq k (degree d)) addnC iterD; congr (iter _ _ _).
by elim: (k %/ _) => //= j IH; rewrite mulSn iterD -IH iter_degree.
Qed.

(* every edge has two darts *)
Lemma edges_double : (edges G).*2 = #|G|.
Proof.
have two d : order alpha d = 2.
  have U : uniq [:: d; alpha d] by rewrite /= inE eq_sym alpha_neq.
  by rewrite (order_cycle _ U (mem_head _ _)) //= alphaK !eqxx.
rewrite -muln2; apply: (fcard_order_set alpha_inj); last by [].
by apply/subsetP=> d _; rewrite inE two.
Qed.

Lemma edges_gt0 d : 0 < edges G.
Proof. by rewrite -double_gt0 edges_double; apply/card_gt0P; exists d. Qed.

Lemma vertices_gt0 d : 0 < vertices G.
Proof.
rewrite /vertices /n_comp_mem (cardD1 (froot sigma d)) !inE.
by rewrite (roots_root (fconnect_sym (@sigma_inj G))).
Qed.

(* turning by k and then by minus k *)
Definition opposite n k := n - k %% n.

Lemma opposite_turn k d : iter (opposite (degree d) k) sigma (iter k sigma d) = d.
Proof.
rewrite /opposite -(turn_modulo_degree k) -iterD subnK ?iter_degree //.
by rewrite ltnW // ltn_mod degree_gt0.
Qed.

Lemma walk_rcons w k d : walk (rcons w k) d = motion k (walk w d).
Proof. by elim: w d => //= a w IH d. Qed.

(* and the way back is made of motions, as many, and a last turn *)
(* line 15 of Algorithm 1: the robot retraces M, coming back to v_u *)
Theorem motions_undone w d :
  exists v j, size v = size w /\ iter j sigma (walk v (walk w d)) = d.
Proof.
elim: w d => [|k w IH] d; first by exists [::], 0.
have [v [j [s E]]] := IH (motion k d).
exists (rcons v j), (opposite (degree d) k); rewrite size_rcons s walk_rcons /= /motion E alphaK.
by split=> //; exact: opposite_turn.
Qed.
End Motions.

Arguments walk_inj {G} w [x1 x2] _.

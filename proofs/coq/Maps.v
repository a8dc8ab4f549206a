(* ---------------------------------------------------------------------------------------------
   Maps, motions, reversibility.                                                  Sections II.A, II.B

   The world is an embedding of a finite connected graph: a combinatorial map.  It is given by its
   darts (a dart is one end of an edge) and two permutations of them:
     sigma d              the next dart clockwise round the same vertex;
     alpha d              the other end of the same edge: an involution without fixed points.
   Vertices are the cycles of sigma, edges those of alpha.  Loops and parallel edges are allowed,
   the surface may have any genus, nothing is said of the number of vertices or edges.

     combinatorial_map    such a pair of permutations on a finite type, connected.  A map G stands
                          for the type of its darts as well: d : G is a dart of G.
     adjacent x y         y is sigma x or alpha x; connected: any two darts are joined by such
                          steps.
     at_same_vertex x y   x and y are darts of one vertex.
     degree d             the number of darts at the vertex of d.
     vertices G, edges G  how many vertices and edges G has: the paper's n and m.
     motion k d           the robot has come in by d (or faces d, at the start); it leaves by the
                          k-th dart clockwise from d, and stands then in the dart at the other
                          end. One motion is one edge traversal; turning on the spot is free.
     walk w d             where the motions of the list w lead from d.
     motions_undone       motions are undone by as many motions and a turn; a last turn is free.

   A robot's state is a dart, not a vertex, because the door by which it came in is all that its
   next turn can refer to.  One law does most of the work: walk_inj, a fixed list of motions leads
   different darts to different darts.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition adjacent (D : finType) (sigma alpha : D -> D) : rel D :=
  fun x y => (y == sigma x) || (y == alpha x).

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

Record combinatorial_map := CombinatorialMap {
  darts_of :> finType;
  sigma : darts_of -> darts_of;
  alpha : darts_of -> darts_of;
  sigma_inj : injective sigma;
  alphaK : involutive alpha;
  alpha_neq : forall d, alpha d != d;
  connected_map : forall x y, connect (adjacent sigma alpha) x y }.

Arguments sigma {c} _.
Arguments alpha {c} _.
Arguments sigma_inj {c} [x1 x2] _.
Arguments alphaK {c} _.
Arguments alpha_neq {c} d.
Arguments connected_map {c} x y.

Section Motions.
Variable G : combinatorial_map.
Implicit Types (d x y : G) (w : seq nat) (k : nat).

Definition at_same_vertex x y := fconnect sigma x y.
Definition degree d := order sigma d.
Definition vertices := fcard (@sigma G) G.
Definition edges := fcard (@alpha G) G.

Definition motion k d := alpha (iter k sigma d).
Fixpoint walk w d := if w is k :: w' then walk w' (motion k d) else d.

(* ---- Motions are reversible ---- *)
Lemma alpha_inj : injective (@alpha G).
Proof. exact: inv_inj alphaK. Qed.

Lemma iter_sigma_inj k : injective (iter k (@sigma G)).
Proof. by elim: k => [|k IH] x y //= /sigma_inj /IH. Qed.

Lemma motion_inj k : injective (motion k).
Proof. by move=> x y /alpha_inj /iter_sigma_inj. Qed.

(* where a list of motions ends determines where it began *)
Theorem walk_inj w : injective (walk w).
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
Lemma edges_double : edges.*2 = #|G|.
Proof.
have two d : order alpha d = 2.
  have U : uniq [:: d; alpha d] by rewrite /= inE eq_sym alpha_neq.
  by rewrite (order_cycle _ U (mem_head _ _)) //= alphaK !eqxx.
rewrite -muln2; apply: (fcard_order_set alpha_inj); last by [].
by apply/subsetP=> d _; rewrite inE two.
Qed.

Lemma vertices_gt0 d : 0 < vertices.
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

Arguments motion {G} k d.
Arguments walk {G} w d.
Arguments walk_inj {G} w [x1 x2] _.

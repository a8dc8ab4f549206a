(* ---------------------------------------------------------------------------------------------
   Percepts in a world with a directional lighthouse.                        Sections II.C and IV

     bearing_inj          at v0 the bearing tells by which dart the robot came in.
     percept_transfer     two darts from which equal turns meet the same percept alike.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Percepts.
Variable W : lighthouse_world.
Implicit Types (d x y : W) (w : seq nat).

Lemma percepts_last w d o : last o (percepts_along w d) = percept_of (walk w d).
Proof. by elim: w d o => //= k w IH d o; rewrite IH. Qed.

Lemma size_percepts w d : size (percepts_along w d) = (size w).+1.
Proof. by elim: w d => //= k w IH d; rewrite IH. Qed.

(* absolute orientation at v0: there the bearing tells by which dart the robot came in *)
Lemma bearing_inj x y j : bearing x = Some j -> bearing y = Some j -> x = y.
Proof.
rewrite /bearing; case: ifP => // cx [jx]; case: ifP => // cy [jy].
by apply: (@iter_sigma_inj _ j); rewrite -{1}jx -jy !iter_findex.
Qed.

Lemma bearing_start : bearing (@start W) = Some (first_bearing W).
Proof. by rewrite /bearing pointed_at_v0. Qed.
End Percepts.

(* two turns from x and from y agree in what they meet: then so do the percepts *)
Lemma order_least (T : finType) (f : T -> T) x n : injective f -> 0 < n -> iter n f x = x ->
  (forall j, 0 < j < n -> iter j f x <> x) -> order f x = n.
Proof.
move=> fi n0 E H; apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt.
  have := findex_iter lt; rewrite E findex0 => e0; by rewrite -e0 in n0.
by apply: (H (order f x)); rewrite ?order_gt0 // iter_order.
Qed.

(* darts that the same turns bring back have one degree *)
Lemma degree_transfer (G H : combinatorial_map) (x : G) (y : H) :
  (forall j, (iter j sigma x == x) = (iter j sigma y == y)) -> degree x = degree y.
Proof.
move=> E; apply: order_least; [exact: sigma_inj | exact: degree_gt0 | by apply/eqP; rewrite E iter_degree |].
move=> j /andP[j0 lj]; apply/eqP; rewrite E; apply/eqP=> F.
by have := findex_iter lj; rewrite F findex0 => e0; rewrite -e0 in j0.
Qed.

Lemma percept_transfer (W W' : lighthouse_world) (d : W) (d' : W') :
  (forall j, (iter j sigma d' == d') = (iter j sigma d == d)) ->
  (forall j, (iter j sigma d' == pointed) = (iter j sigma d == pointed)) ->
  percept_of d' = percept_of d.
Proof.
move=> H P; have E : degree d' = degree d by exact: degree_transfer.
rewrite /percept_of E /bearing; congr (_, _).
have C : at_same_vertex d' pointed = at_same_vertex d pointed.
  by apply/idP/idP=> /iter_findex /eqP; [rewrite P|rewrite -P] => /eqP <-; exact: fconnect_iter.
rewrite C; case: ifP => // c; have := iter_findex c => /eqP; rewrite -P => /eqP <-.
by rewrite findex_iter // -/(degree d') E; exact: findex_max.
Qed.


(* ---------------------------------------------------------------------------------------------
   No smaller planar pair.                                                            Section III

   As Minimality.v, for simple planar worlds with at most 7 edges: 4,526 maps, 3,387 of them planar.
   This takes 13 s of vm_compute, and would take the lazy machine of coqchk some minutes: coqchk is told
   to use the virtual machine too for this file.

   With 6 edges a planar map has two starts at v0 that look alike and are not the same: the robot can tell
   the map, not its place.  So the conclusion is that the maps are the same with v0 on v0.

     planar_walk            47 motions.
     planar_worlds_differ   they tell all simple planar worlds with at most 7 edges apart, up to the dart
                            of v0 that the robot faces first.
     no_planar_twins        so such worlds that look alike are the same map, with v0 on v0.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes NumberedWorlds Enumeration Twins Cluster.
From Allworlds Require Import SameWorld PositionTwins SimpleMaps Minimality.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition planar_walk :=
  [:: 1; 1; 1; 1; 1; 1; 2; 1; 1; 1; 1; 1; 1; 2; 1; 1; 1; 2; 1; 3; 1; 1; 1; 1; 1; 2; 1; 1; 2; 1; 2; 1; 1;
      3; 1; 1; 1; 1; 2; 1; 1; 2; 1; 1; 1; 1; 1].

Lemma planar_told_apart : told_apart the_same_at_v0 planar_walk (simple_maps_up_to 7).
Proof. vm_cast_no_check (erefl true). Qed.

Section Worlds.
Variables (G H : combinatorial_map) (d : G) (e : H).
Hypotheses (simple_G : simple_world G) (simple_H : simple_world H).
Hypotheses (planar_G : planar_map G) (planar_H : planar_map H).

Theorem planar_worlds_differ : edges G <= 7 -> edges H <= 7 -> walk_alike d e planar_walk ->
  exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e').
Proof.
move=> lG lH A; apply: (the_same_planar_worlds A _ _ planar_G planar_H planar_told_apart).
  exact: (simple_listed d lG simple_G).
exact: (simple_listed e lH simple_H).
Qed.

Theorem no_planar_twins : look_alike d e -> edges G <= 7 ->
  exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e').
Proof.
move=> A lG; have lH := lG; rewrite (alike_edges A) in lH.
exact: planar_worlds_differ (A _).
Qed.
End Worlds.

(* Examples.v -- Algorithm 1 run inside Coq *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Rooted.
From Allworlds Require Import Lighthouse Algorithm.
Import Rooted.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Definition test M pt fuel := let: (t, e, z) := mrun (gmv (den M)) (tobs M pt) fuel (Ret (first_state (tobs M pt (rrt M)))) (rrt M) in
  (size t, if e is Some N then same N (Rmap (rsg M) (ral M) z) else false).
Definition testX M pt fuel := let: (t, e, z) := @episode _ _ algorithm1X (den M) (tobs M pt) fuel in
  (size t, if e is Some N then same N (Rmap (rsg M) (ral M) z) else false).
Definition loops2 := Rmap [:: 1;2;3;0] [:: 1;0;3;2] 0.
Definition theta := Rmap [:: 1;2;0;4;5;3] [:: 3;5;4;0;2;1] 0.
Definition K4 := Rmap [:: 1;2;0;4;5;3;7;8;6;10;11;9] [:: 3;6;9;0;11;7;1;5;10;2;8;4] 0.
Definition all_bearings M := [seq test M b 400 | b <- iota 0 (tobs M 0 0).1].
Definition all_bearingsX M := [seq testX M b 400 | b <- iota 0 (tobs M 0 0).1].
Example worlds_valid : all valid [:: loops2; theta; K4]. Proof. by vm_compute. Qed.
Example run_loops2 : all_bearings loops2 = nseq 4 (2, true). Proof. by vm_compute. Qed.
Example run_theta : all_bearings theta = nseq 3 (8, true). Proof. by vm_compute. Qed.
Example run_K4 : all_bearings K4 = nseq 3 (35, true). Proof. by vm_compute. Qed.
Example runX : map all_bearingsX [:: loops2; theta; K4] = map all_bearings [:: loops2; theta; K4]. Proof. by vm_compute. Qed.

(* ---------------------------------------------------------------------------------------------
   Extraction to OCaml: the explorers, step by step, their policies, the judge.

     algorithm1_starts, cluster_starts, natural_starts   what the explorer with each lighthouse does
                          from its first percept on.
     algorithm1_next, cluster_next, natural_next   its next motion, or the end.
     algorithm1_machine   a whole run.

   Trusted here: the extraction itself; ExtrOcamlBasic and ExtrOcamlNatInt (nat becomes int: no
   number in a run comes near 2^62, the largest is a product of two list lengths); and three
   hand-written realisations, eqn as (=), modn as (mod) with a mod 0 = a, addition as (+).
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Percepts RootedMaps Codes Explorers Algorithm Policies.
From Allworlds Require Import NumberedWorlds Judge Cluster NaturalLighthouse.
Require Extraction.
Require Import ExtrOcamlBasic ExtrOcamlNatInt.

Extract Inlined Constant ssrnat.eqn => "(fun (a : int) b -> a = b)".
Extract Inlined Constant div.modn => "(fun a b -> if b = 0 then a else a mod b)".
Extract Inlined Constant Nat.add => "(+)".

Definition algorithm1_starts := set_out directional.
Definition algorithm1_next := next directional.
Definition algorithm1_machine pol := machine directional pol.
Definition cluster_starts := set_out cluster.
Definition cluster_next := next cluster.
(* a, b: the degrees of v0, the first percept, and of v1, which is told *)
Definition natural_starts (a b : nat) := set_out (natural a b).
Definition natural_next (a b : nat) := next (natural a b).

Set Warnings
  "-extraction-default-directory,-extraction-opaque-accessed,-extraction-reserved-identifier".
Extraction "ocaml/certified.ml"
  algorithm1_starts algorithm1_next algorithm1_machine cluster_starts cluster_next
  natural_starts natural_next fifo lifo nearest valid dart_order same_code judge sensed.

(* ---------------------------------------------------------------------------------------------
   Extraction to OCaml: the explorers, step by step, their policies, the judge; the checker; folding; the
   search for pairs that look alike.

     algorithm1_starts, cluster_starts, natural_starts, door_starts   what the explorer with each
                          lighthouse does from its first percept on.
     algorithm1_next, cluster_next, natural_next, door_next   its next motion, or the end.
     algorithm1_machine   a whole run.
     check, refutations   Checker.v; directional_check is check with directional_senses and
                          in_universe_in u, and so on (TwoVerticesChecker.v).
     algorithm1_explorer  the explorer as a function of all that it has sensed;
     shield_of X pol      Shield.v: the shield of X with Algorithm 1.
     table_checks, table_of, twins   tables of sensors, and the kernel's (WeakestSensors.v).
     folded_log           of the first percept and the steps of a log: whether it leaves no dart open, and
                          the folded map.

   Trusted here: the extraction itself; ExtrOcamlBasic and ExtrOcamlNatInt (nat becomes int: no
   number in a run comes near 2^62, the largest is a product of two list lengths); three hand-written
   realisations, eqn as (=), modn as (mod) with a mod 0 = a, addition as (+); and the seven functions on
   lists of ocaml/tail.ml and OCaml's own List.length, which need no stack.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Percepts RootedMaps Codes Explorers Algorithm Policies.
From Allworlds Require Import NumberedWorlds Judge Cluster NaturalLighthouse Log FoldingProgram SameWorld.
From Allworlds Require Import Checker TwoVerticesChecker Shield SimpleMaps Minimality PlanarMinimality.
From Allworlds Require Import Door WeakestSensors.
Require Extraction.
Require Import ExtrOcamlBasic ExtrOcamlNatInt.

Extract Inlined Constant ssrnat.eqn => "(fun (a : int) b -> a = b)".
Extract Inlined Constant div.modn => "(fun a b -> if b = 0 then a else a mod b)".
Extract Inlined Constant Nat.add => "(+)".
Extract Inlined Constant seq.size => "Stdlib.List.length".
Extract Inlined Constant seq.cat => "Tail.cat".
Extract Inlined Constant seq.rcons => "Tail.rcons".
Extract Inlined Constant seq.map => "Tail.map".
Extract Inlined Constant seq.filter => "Tail.filter".
Extract Inlined Constant seq.pmap => "Tail.pmap".
Extract Inlined Constant seq.foldr => "Tail.foldr".
Extract Inlined Constant seq.iota => "Tail.iota".

Definition algorithm1_starts := set_out directional.
Definition algorithm1_next := next directional.
Definition algorithm1_machine pol := machine directional pol.
Definition cluster_starts := set_out cluster.
Definition cluster_next := next cluster.
(* a, b: the degrees of v0, the first percept, and of v1, which is told *)
Definition natural_starts (a b : nat) := set_out (natural a b).
Definition natural_next (a b : nat) := next (natural a b).
Definition door_starts := set_out door.
Definition door_next := next door.

Definition algorithm1_explorer pol := algorithm1 pol.
Definition shield_of E (X : explorer percept E) pol := shield X (algorithm1 pol).

Definition folded_log first (taken : seq (nat * percept)) :=
  let L := Log first taken in (folds L, folded_map L).

Set Warnings
  "-extraction-default-directory,-extraction-opaque-accessed,-extraction-reserved-identifier".
Extraction "ocaml/certified.ml"
  algorithm1_starts algorithm1_next algorithm1_machine cluster_starts cluster_next
  natural_starts natural_next door_starts door_next fifo lifo nearest valid dart_order same_code judge sensed
  check refutations worlds examine run_in paper_limit two_vertices_limit vertices_in edges_in
  directional_senses in_universe_in cluster_senses one_edge_in natural_senses natural_in
  algorithm1_resumption cluster_resumption natural_resumption folded_log
  algorithm1_explorer shield_of
  simple_maps planar_in told_apart the_same the_same_at_v0 simple_walk planar_walk
  table_checks table_of twins.

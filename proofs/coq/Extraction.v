(* ---------------------------------------------------------------------------------------------
   Extraction to OCaml: the explorer, step by step, its policies, the judge.

     first_knowledge      line 1.
     algorithm1_next      the next motion, or the end.
     algorithm1_machine   a whole run.

   Trusted here: the extraction itself; ExtrOcamlBasic and ExtrOcamlNatInt (nat becomes int: no
   number in a run comes near 2^62, the largest is a product of two list lengths); and three
   hand-written realisations, eqn as (=), modn as (mod) with a mod 0 = a, addition as (+).
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Percepts RootedMaps Explorers Algorithm Policies NumberedWorlds Judge.
Require Extraction.
Require Import ExtrOcamlBasic ExtrOcamlNatInt.

Extract Inlined Constant ssrnat.eqn => "(fun (a : int) b -> a = b)".
Extract Inlined Constant div.modn => "(fun a b -> if b = 0 then a else a mod b)".
Extract Inlined Constant Nat.add => "(+)".

Definition algorithm1_next := next directional.
Definition algorithm1_machine pol := machine directional pol.

Set Warnings
  "-extraction-default-directory,-extraction-opaque-accessed,-extraction-reserved-identifier".
Extraction "ocaml/certified.ml"
  first_knowledge algorithm1_next algorithm1_machine fifo lifo nearest valid dart_order same_code judge sensed.

(* ---------------------------------------------------------------------------------------------
   Extraction to OCaml: the explorer, step by step (next, first_knowledge), its policies, the judge.

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

Set Warnings
  "-extraction-default-directory,-extraction-opaque-accessed,-extraction-reserved-identifier".
Extraction "ocaml/certified.ml"
  next first_knowledge machine fifo lifo nearest valid dart_order same_code judge sensed.

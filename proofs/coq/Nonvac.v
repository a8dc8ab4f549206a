(* Nonvac.v -- the hypothesis of directional_at_least_m is met, by Algorithm 1 itself *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Rooted.
From Allworlds Require Lighthouse Algorithm Refine Lower.
Set Implicit Arguments.
Lemma algorithm1_makes_m_motions (D : finType) (s a : D -> D) r pt : injective s -> involutive a -> (forall d, a d != d) ->
  (forall x y, connect (Lighthouse.adj s a) x y) -> fconnect s r pt -> exists fuel t e z,
  @episode _ _ Algorithm.algorithm1X (Lower.world s a r) (Lighthouse.obs s pt) fuel = (t, Some e, z) /\ #|D| <= (size t).*2.
Proof.
apply: (@Lower.directional_at_least_m _ den) => D' s' a' r' pt' i k n c f; exact: (Refine.algorithm1_right i k n c f).
Qed.

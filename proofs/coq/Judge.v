(* ---------------------------------------------------------------------------------------------
   The judge: is an answer the world's map, and is the robot where it says?               Section V

     verdict              IsRight; WrongPose: the map is right and the place in it is not;
                          WrongMap.
     judge M z e          of the answer e, the world being M and the robot standing in its dart z.
   judge_right, judge_pose, judge_map: in a valid and connected world the verdict is each time the
   sentence that it stands for.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes NumberedWorlds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive verdict := IsRight | WrongPose | WrongMap.

Definition judge (M : numbered_map) z (e : numbered_map) : verdict :=
  if ~~ valid e then WrongMap
  else if same_code (seen_from M z) e then IsRight
  else if has (fun d => same_code (seen_from M d) e) (iota 0 (size (sigma_list M))) then WrongPose
  else WrongMap.

Section Judge.
Variables (M e : numbered_map) (z : nat).
Hypotheses (V : valid M) (C : connected (denote M)) (zM : z < size (sigma_list M)).

(* the answer denotes a map, and that map is the world seen from dart d *)
Definition is_world_from d :=
  wellformed (denote e) /\ isomorphic (denote (seen_from M d)) (denote e).

Lemma seen_from_valid d : d < size (sigma_list M) -> valid (seen_from M d).
Proof. by move=> ld; case/and5P: V => s1 _ s3 s4 s5; apply/and5P. Qed.

Lemma seen_from_connected d : d < size (sigma_list M) -> connected (denote (seen_from M d)).
Proof.
move=> ld; have I := numbers_isomorphic (Ordinal ld : in_numbers V C).
have J := isomorphic_sym (rooted_wellformed _) I.
apply: (isomorphic_connected (validP (seen_from_valid ld)) J); exact: rooted_connected.
Qed.

Lemma judgeP d : valid e -> d < size (sigma_list M) ->
  reflect (isomorphic (denote (seen_from M d)) (denote e)) (same_code (seen_from M d) e).
Proof. by move=> Ve ld; apply: same_codeP => //;
  [exact: seen_from_valid | exact: seen_from_connected]. Qed.

Hypothesis lists : size (alpha_list e) = size (sigma_list e).

Lemma not_valid d : ~~ valid e -> ~ is_world_from d.
Proof. by move=> /negP Nv [We _]; apply: Nv; exact: validI. Qed.

Theorem judge_right : judge M z e = IsRight <-> is_world_from z.
Proof.
rewrite /judge; case Ve: (valid e) => /=; last by split=> // /not_valid []; rewrite ?Ve.
case: judgeP => // [I|N]; first by split=> // _; split; first exact: validP.
by split=> [|[_ /N]] //; case: ifP.
Qed.

Theorem judge_pose : judge M z e = WrongPose <->
  ~ is_world_from z /\ exists2 d, d < size (sigma_list M) & is_world_from d.
Proof.
rewrite /judge; case Ve: (valid e) => /=; last first.
  by split=> // -[_ [d _ /not_valid []]]; rewrite ?Ve.
case: judgeP => // [I|N]; first by split=> // -[[]]; split; first exact: validP.
case: ifP => [/hasP[d]|/hasP H]; last first.
  split=> // -[_ [d ld [_ I]]]; case: H; exists d; rewrite ?mem_iota //.
  exact/judgeP.
rewrite mem_iota /= => ld /(judgeP Ve ld) I; split=> // _; split=> [[_ /N]|] //.
by exists d; last by split; first exact: validP.
Qed.

Theorem judge_map : judge M z e = WrongMap <->
  forall d, d < size (sigma_list M) -> ~ is_world_from d.
Proof.
have R := judge_right; have P := judge_pose; case: (judge M z e) R P => -[R1 R2] [P1 P2].
- by split=> // /(_ z zM) []; exact: R1.
- by split=> //; have [_ [d ld H]] := P1 erefl => /(_ d ld).
split=> // _ d ld H; have N : ~ is_world_from z by move/R2.
by have: WrongMap = WrongPose by apply: P2; split=> //; exists d.
Qed.
End Judge.

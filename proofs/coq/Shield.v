(* ---------------------------------------------------------------------------------------------
   The shield: any explorer, made right.                                          Sections IV-VI

   Two guests take turns: any explorer X, and one that is known to be right.  In its turn a guest explores
   from the start, and then the robot goes back by undoing its motions.  Everything that is sensed goes
   into one log; as soon as no dart of it is open the folded map (FoldingProgram.v) is the answer, and what
   the guests answer is never looked at.

     outing X b seen done c   X's turn: at most b motions, and back to the start.  seen: what X has sensed in
                          it; done: what is to be undone; c: how far the robot has yet to turn, to face as
                          it did at the start.  The result is how far it has to turn then.
     turned_first c t     the transcript t, its first motion made after a turn by c.
     both_out X Y o k c      the turns of X and of Y with at most 2^(2k) and 2^(2k+1) motions; o: the first
                          percept.
     rounds n k c         n rounds, from the k-th on.
     shield X Y           an explorer that keeps a state: the log, which round is next, and what is left of
                          the one that it is in.

     outing_makes           in its turn X senses what it senses by itself, and the robot ends where it began.
     guest_folds          if a transcript of X leaves no dart open, nor does a log that ends with it, after
                          motions that led back to the start.
     stops                the shield stops as soon as its log leaves no dart open.
     shield_by_first, shield_by_second   so it is right within nine times the motions of X, or of Y, if
                          the log of these leaves no dart open.
     shield_correct       the shield with Algorithm 1 is right within 9 ((1) + (2)), whatever X is.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Algorithm Execution Refinement.
From Allworlds Require Import Congruence Log Folding OpenDarts FoldingProgram LowerBounds Checker.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Programs, executed: one after the other, and where the same is sensed ---- *)
Section Exec.
Variable W : lighthouse_world.
Local Notation exec := (exec (@percept_of W)).

Lemma exec_bind A B (p : program percept A) (f : A -> program percept B) d :
  exec (bind p f) d = let: (x, z, t) := exec p d in let: (y, z', t') := exec (f x) z in (y, z', t ++ t').
Proof.
elim: p d => [x|k g IH] d /=; first by case: (exec (f x) d) => [[y z'] t'].
by rewrite IH; case: (exec (g _) _) => [[x z] t] /=; case: (exec (f x) z) => [[y z'] t'].
Qed.

Lemma exec_log A (p : program percept A) d x z t : exec p d = (x, z, t) ->
  percepts_along (unzip1 t) d = percept_of d :: unzip2 t /\ z = walk (unzip1 t) d.
Proof.
elim: p d t => [x'|k g IH] d t /=; first by case=> _ -> <-.
case E: (exec _ _) => [[x1 z1] t1] [? ? <-]; subst x1 z1 => /=.
by have [-> ->] := IH _ _ _ E.
Qed.
End Exec.

Lemma exec_replay (W V : lighthouse_world) A (p : program percept A) (d : W) (d' : V) x z t :
  exec (@percept_of W) p d = (x, z, t) -> percepts_along (unzip1 t) d' = percept_of d' :: unzip2 t ->
  exec (@percept_of V) p d' = (x, walk (unzip1 t) d', t).
Proof.
elim: p d d' t => [x'|k g IH] d d' t /=; first by case=> -> _ <-.
case E: (exec _ _ _) => [[x1 z1] t1] [? ? <-]; subst x1 z1 => /= -[P].
have ph : percept_of (motion k d') = percept_of (motion k d).
  by have := congr1 (head (0, None)) P; case: (unzip1 t1).
by rewrite ph (IH _ _ (motion k d') _ E) // P ph.
Qed.

Lemma percepts_cat (W : lighthouse_world) v w (d : W) o s s' : size s = size v ->
  percepts_along (v ++ w) d = o :: s ++ s' <->
  percepts_along v d = o :: s /\ percepts_along w (walk v d) = percept_of (walk v d) :: s'.
Proof.
elim: v d o s => [|k v IH] d o [|o' s] //=.
  by case: w => [|j w] _ /=; split=> [[-> ->]|[[->] [->]]].
case=> sz; split=> [[-> P]|[[-> P] Q]]; first by have [-> ->] := (IH _ _ _ sz).1 P.
by congr (_ :: _); apply/(IH _ _ _ sz).
Qed.

(* the first motions of an explorer do not depend on how many it may make *)
Lemma explore_prefix P E (X : explorer P E) M (obs : carrier M -> P) b b' seen d t e z :
  explore X M obs b seen d = (t, e, z) -> size t <= b' ->
  exists t', (explore X M obs b' seen d).1.1 = t ++ t'.
Proof.
elim: b b' seen d t => [|b IH] b' seen d t /=; case EX: (X seen) => [k|a].
- by case=> <- _ _ _; eexists.
- by case=> <- _ _ _; eexists.
- case R: (explore _ _ _ _ _ _) => [[t1 e1] z1] [<- ? ?]; subst e1 z1.
  case: b' => [|b'] //= s; rewrite EX; have [t' E'] := IH b' _ _ _ R s.
  by exists t'; case: (explore X M obs b' _ _) E' => [[t2 e2] z2] /= ->.
by case=> <- _ _ _; eexists.
Qed.

Lemma explore_within P E (X : explorer P E) M (obs : carrier M -> P) b seen d :
  size (explore X M obs b seen d).1.1 <= b.
Proof.
elim: b seen d => [|b IH] seen d /=; case: (X seen) => // k.
by have := IH (rcons seen (obs (motion_in M k d))) (motion_in M k d); case: explore => [[t e] z].
Qed.

(* ---- A turn ---- *)
Section Turn.
Variables (E : Type) (X : explorer percept E).

Fixpoint outing b (seen : seq percept) (done : seq (nat * nat)) c : program percept nat :=
  match b, X seen with
  | b'.+1, Move k =>
      Go (c + k) (fun o => outing b' (rcons seen o) ((k, (last (0, None) seen).1) :: done) 0)
  | _, _ => go_back percept done c
  end.

Lemma outing_goes b seen done c k : 0 < b -> X seen = Move k -> outing b seen done c =
  Go (c + k) (fun o => outing b.-1 (rcons seen o) ((k, (last (0, None) seen).1) :: done) 0).
Proof. by case: b => //= b _ ->. Qed.

(* the first of these motions is made after a turn by c *)
Definition turned_first c (t : seq (nat * percept)) := if t is (k, o) :: t' then (c + k, o) :: t' else t.

Lemma turned_first0 t : turned_first 0 t = t. Proof. by case: t => [|[k o] t]. Qed.

Lemma size_turned_first c t : size (turned_first c t) = size t. Proof. by case: t => [|[k o] t]. Qed.

Lemma take_turned_first c t t' s : take (size t) (turned_first c (t ++ t') ++ s) = turned_first c t.
Proof. by case: t => [|[k o] t] /=; rewrite ?take0 // -catA take_size_cat. Qed.

Variable W : lighthouse_world.
Local Notation course := (explore X (rooted (@start W)) (@percept_of W)).
Local Notation exec := (exec (@percept_of W)).

Lemma along_turned_first c (d x : W) t : due c d x ->
  percepts_along (unzip1 (turned_first c t)) d = percept_of d :: unzip2 (turned_first c t) <->
  percepts_along (unzip1 t) x = percept_of x :: unzip2 t.
Proof.
move=> du; case: t => [|[k o] t] //=; rewrite (motion_due k du).
by split=> [[->]|[->]].
Qed.

Lemma outing_makes b seen (x : W) done c d t e z :
  due c d x -> trail done x (@start W) -> last (0, None) seen = percept_of x ->
  course b seen x = (t, e, z) ->
  exists c' z' s, [/\ exec (outing b seen done c) d = (c', z', turned_first c t ++ s),
                      size s = size done + size t & due c' z' (@start W)].
Proof.
have home done' c1 (d1 y : W) : due c1 d1 y -> trail done' y (@start W) ->
    exists c' z' s, [/\ exec (go_back percept done' c1) d1 = (c', z', s), size s = size done' &
                        due c' z' (@start W)].
  move=> du tr; have [c' [z' [[s [R sz]] D]]] := go_back_makes (@percept_of W) du tr.
  by exists c', z', s.
elim: b seen x done c d t => [|b IH] seen x done c d t du tr la /=; case EX: (X seen) => [k|a].
- by case=> <- _ _; have [c' [z' [s [R sz D]]]] := home _ _ _ _ du tr; exists c', z', s; rewrite addn0.
- by case=> <- _ _; have [c' [z' [s [R sz D]]]] := home _ _ _ _ du tr; exists c', z', s; rewrite addn0.
- case R: (explore _ _ _ _ _ _) => [[t1 e1] z1] [<- ? ?]; subst e1 z1.
  have tr' : trail ((k, (last (0, None) seen).1) :: done) (motion k x) (@start W).
    by exists x; rewrite la.
  have du' : due 0 (motion k x) (motion k x) by [].
  have [c' [z' [s [R' sz D]]]] := IH _ _ _ _ _ _ du' tr' (last_rcons _ _ _) R.
  exists c', z', s; split=> //; last by rewrite sz /= addSnnS.
  by rewrite /= (motion_due k du) R' turned_first0.
by case=> <- _ _; have [c' [z' [s [R sz D]]]] := home _ _ _ _ du tr; exists c', z', s; rewrite addn0.
Qed.

Lemma outing_loops b c d : due c d (@start W) -> exists c' z' s,
  [/\ exec (outing b [:: percept_of (@start W)] [::] c) d = (c', z', s), size s <= 2 * b &
      due c' z' (@start W)].
Proof.
move=> du; case R: (course b [:: percept_of (@start W)] (@start W)) => [[t e] z].
have [c' [z' [s [E1 sz D]]]] := outing_makes (seen := [:: _]) (done := [::]) du (erefl _) (erefl _) R.
exists c', z', (turned_first c t ++ s); split=> //.
have := @explore_within _ _ X (rooted (@start W)) (@percept_of W) b [:: percept_of (@start W)] (@start W).
by rewrite R /= => le; rewrite size_cat size_turned_first sz add0n mul2n -addnn leq_add.
Qed.
End Turn.

(* ---- A log with the course of a guest in it ---- *)
Section GuestFolds.
Variables (E : Type) (X : explorer percept E) (W : lighthouse_world).
Local Notation o := (percept_of (@start W)).
Variable p : program percept nat.
Hypothesis loops : forall V : lighthouse_world, percept_of (@start V) = o -> forall c z t,
  exec (@percept_of V) p (@start V) = (c, z, t) -> due c z (@start V).

Lemma guest_folds b c z t0 t e z' : exec (@percept_of W) p (@start W) = (c, z, t0) ->
  episode X (rooted (@start W)) (@percept_of W) b = (t, e, z') ->
  no_open_dart (log_of W t) -> no_open_dart (log_of W (t0 ++ turned_first c t)).
Proof.
move=> R0 R nopen; have [P0 Z0] := exec_log R0; have [P _] := explore_log R.
have sz : size (unzip2 t0) = size (unzip1 t0) by rewrite !size_map.
have A : agrees W (log_of W (t0 ++ turned_first c t)).
  rewrite /agrees /motions /percepts /= /unzip1 /unzip2 !map_cat; apply/(percepts_cat _ _ _ _ sz).
  by split=> //; rewrite -Z0; apply/(along_turned_first _ (loops (erefl _) R0)).
have key V : agrees V (log_of W (t0 ++ turned_first c t)) -> agrees V (log_of W t).
  rewrite /agrees /motions /percepts /= /unzip1 /unzip2 !map_cat => /(percepts_cat _ _ _ _ sz)[P1 P2].
  have same : percept_of (@start V) = o by clear -P1; case: t0 P1 => [|q t0] /(congr1 (head (0, None))).
  have R1 := exec_replay R0 (etrans P1 (f_equal (cons^~ _) (esym same))).
  by have /(along_turned_first _ (loops same R1)) := P2; rewrite same.
apply/(no_open_dart_iff A) => V1 V2 /key A1 /key A2.
by have := folding_isomorphic A1 A2 nopen (leq0n _); rewrite /robot_at !take0.
Qed.
End GuestFolds.

Lemma nothing_walked (W : lighthouse_world) : ~ no_open_dart (log_of W [::]).
Proof. by move=> /(_ (dart_at _ 0 0))/existsP[q /gluedP[p _ /hasP[i]]]. Qed.

(* ---- The shield ---- *)
Record shield_state := ShieldState {
  sensed_first : percept;
  steps_so_far : seq (nat * percept);
  next_round : nat;
  left_to_do : program percept nat }.

Section Shield.
Variables (E F : Type) (X : explorer percept E) (Y : explorer percept F).

Definition both_out o k c := bind (outing X (2 ^ k.*2) [:: o] [::] c) (outing Y (2 ^ k.*2.+1) [:: o] [::]).

Definition shield_step s :=
  match left_to_do s with
  | Go m f => Some (m, f, next_round s)
  | Return c =>
      if both_out (sensed_first s) (next_round s) c is Go m f then Some (m, f, (next_round s).+1) else None
  end.

Arguments shield_step : simpl never.

Definition shield : resumption shield_state percept :=
  {| begins := fun o => ShieldState o [::] 0 (Return 0);
     decides := fun s =>
       let L := Log (sensed_first s) (steps_so_far s) in
       if folds L then Stop (folded_map L)
       else if shield_step s is Some (m, _, _) then Move m else Stop (folded_map L);
     goes_on := fun s o =>
       if shield_step s is Some (m, f, k)
       then ShieldState (sensed_first s) (rcons (steps_so_far s) (m, o)) k (f o)
       else s |}.

Fixpoint rounds o n k c := if n is n'.+1 then bind (both_out o k c) (rounds o n' k.+1) else Return c.

Section Loops.
Variable W : lighthouse_world.
Local Notation o := (percept_of (@start W)).
Local Notation exec := (exec (@percept_of W)).

Lemma exec_bind_return (p : program percept nat) (d : W) : exec (bind p (fun c => Return c)) d = exec p d.
Proof. by rewrite exec_bind; case: (exec p d) => [[x z] t] /=; rewrite cats0. Qed.

Lemma exec_rounds n k c d : exec (rounds o n.+1 k c) d = exec (bind (rounds o n k c) (both_out o (k + n))) d.
Proof.
elim: n k c d => [|n IH] k c d; first by rewrite addn0; exact: exec_bind_return.
rewrite -[rounds o n.+2 k c]/(bind (both_out o k c) (rounds o n.+1 k.+1)).
rewrite -[rounds o n.+1 k c]/(bind (both_out o k c) (rounds o n k.+1)) [LHS]exec_bind [RHS]exec_bind.
rewrite [in RHS]exec_bind; case: (exec (both_out o k c) d) => [[c1 z1] t1]; rewrite IH exec_bind addSnnS.
case: (exec (rounds o n k.+1 c1) z1) => [[c2 z2] t2].
by case: (exec (both_out o (k + n.+1) c2) z2) => [[c3 z3] t3]; rewrite catA.
Qed.

Lemma both_out_loops k c d : due c d (@start W) -> exists c' z' s,
  [/\ exec (both_out o k c) d = (c', z', s), size s <= 6 * 2 ^ k.*2 & due c' z' (@start W)].
Proof.
move=> du; have [c1 [z1 [s1 [R1 l1 D1]]]] := outing_loops X (2 ^ k.*2) du.
have [c2 [z2 [s2 [R2 l2 D2]]]] := outing_loops Y (2 ^ k.*2.+1) D1.
exists c2, z2, (s1 ++ s2); split=> //; first by rewrite /both_out exec_bind R1 R2.
by rewrite size_cat (mulnDl 2 4) leq_add // (leq_trans l2) // expnS mulnA.
Qed.

Lemma rounds_loop n k c d : due c d (@start W) -> exists c' z' s,
  [/\ exec (rounds o n k c) d = (c', z', s), size s + 2 * 2 ^ k.*2 <= 2 * 2 ^ (k + n).*2 &
      due c' z' (@start W)].
Proof.
elim: n k c d => [|n IH] k c d du; first by exists c, d, [::]; rewrite addn0.
have [c1 [z1 [s1 [R1 l1 D1]]]] := both_out_loops k du; have [c2 [z2 [s2 [R2 l2 D2]]]] := IH k.+1 _ _ D1.
exists c2, z2, (s1 ++ s2); split=> //; first by rewrite /= exec_bind R1 R2.
rewrite -addSnnS; apply: leq_trans l2; rewrite size_cat -addnA addnCA leq_add2l.
by rewrite doubleS !expnS !mulnA (mulnDl 6 2) leq_add2r.
Qed.

Lemma rounds_from_start n : exists c z s, [/\ exec (rounds o n 0 0) (@start W) = (c, z, s),
  size s + 2 <= 2 * 2 ^ n.*2 & due c z (@start W)].
Proof.
have [c [z [s [R l D]]]] := rounds_loop n 0 (erefl _ : due 0 (@start W) (@start W)).
by exists c, z, s; rewrite add0n in l.
Qed.
End Loops.

(* ---- It stops as soon as no dart is open ---- *)
Section World.
Variable W : lighthouse_world.
Local Notation o := (percept_of (@start W)).
Local Notation exec := (exec (@percept_of W)).
Local Notation run := (run_from shield motion (@percept_of W)).

Hypothesis Y_moves : forall k c, exists m f, both_out o k c = Go m f.

Lemma step_taken n k p d c z tr : exec (bind p (rounds o n k)) d = (c, z, tr) -> tr <> [::] ->
  exists m f k' n', (forall t, shield_step (ShieldState o t k p) = Some (m, f, k')) /\
    exec (bind (Go m f) (rounds o n' k')) d = (c, z, tr).
Proof.
case: p => [c1|m f] R ne; last by exists m, f, k, n.
case: n R => [|n] R; first by case: R ne => _ _ <-.
have [m [f ER]] := Y_moves k c1; exists m, f, k.+1, n; split; first by move=> t; rewrite /shield_step /= ER.
by rewrite -ER.
Qed.

Lemma stops i fuel n k p d c z tr t0 : exec (bind p (rounds o n k)) d = (c, z, tr) ->
  folds (Log o (t0 ++ take i tr)) -> i <= size tr -> i <= fuel ->
  exists j, [/\ j <= i, folds (Log o (t0 ++ take j tr)) &
    run fuel (ShieldState o t0 k p) d
      = (take j tr, Some (folded_map (Log o (t0 ++ take j tr))), walk (unzip1 (take j tr)) d)].
Proof.
elim: i fuel n k p d tr t0 => [|i IH] fuel n k p d tr t0 R Fo li lf.
  by exists 0; rewrite take0 cats0 in Fo *; split=> //; case: fuel {lf} => [|fuel] /=; rewrite Fo.
have [F0|F0] := boolP (folds (Log o t0)).
  by exists 0; rewrite take0 cats0; split=> //; case: fuel {lf} => [|fuel] /=; rewrite F0.
have ne : tr <> [::] by move=> E0; rewrite E0 in li.
have [m [f [k' [n' [SN EQ]]]]] := step_taken R ne.
case: fuel lf => // fuel lf; case: tr li Fo EQ {R ne} => // q tr li Fo.
rewrite [bind _ _]/= [exec _ _]/=; case R: (exec _ _) => [[c1 z1] t1] [? ? Eq Et]; subst c1 z1 q t1.
have [|j [lj Fj Rj]] := IH fuel n' k' _ _ tr (rcons t0 (m, percept_of (motion m d))) R _ li lf.
  by rewrite cat_rcons.
exists j.+1; rewrite cat_rcons in Fj Rj; split=> //=; rewrite (negbTE F0) SN /= Rj.
by [].
Qed.

(* ---- So a guest whose course leaves no dart open is enough ---- *)
Local Notation right_in limit :=
  (right_within (as_explorer shield) (M := rooted (@start W)) (@percept_of W) limit).

Lemma right_when_folded n i c z tr : exec (rounds o n 0 0) (@start W) = (c, z, tr) ->
  i <= size tr -> no_open_dart (log_of W (take i tr)) -> right_in i.
Proof.
move=> R li /folds_no_open_dart Fo.
have [j [lj Fj Rj]] := stops (p := Return 0) (t0 := [::]) R Fo li (leqnn i).
exists i, (take j tr), (folded_map (Log o (take j tr))), (walk (unzip1 (take j tr)) (@start W)).
have [P _] := exec_log R; have A : agrees W (log_of W (take j tr)).
  rewrite -{1 2}(cat_take_drop j tr) /unzip1 /unzip2 !map_cat in P.
  by have [] := (percepts_cat _ _ _ _ (etrans (size_map _ _) (esym (size_map _ _)))).1 P.
have [V I] := folded_map_is_the_world A ((folds_no_open_dart _).1 Fj).
split=> //; first by rewrite episode_resumption episode_ofE.
  by rewrite size_take; case: ifP => // ge; apply: leq_trans lj; rewrite leqNgt ge.
have all L : take (size (steps L)) (motions L) = motions L by rewrite take_oversize // size_map.
by move: I; rewrite /robot_at all.
Qed.

Lemma by_guest H (G : explorer percept H) (p : program percept nat) q b n c z t0 b' t e z' :
  (forall V : lighthouse_world, percept_of (@start V) = o -> forall c z t,
    Execution.exec (@percept_of V) p (@start V) = (c, z, t) -> due c z (@start V)) ->
  exec p (@start W) = (c, z, t0) ->
  exec (rounds o n 0 0) (@start W) =
    exec (bind p (fun c => bind (outing G b [:: o] [::] c) q)) (@start W) ->
  episode G (rooted (@start W)) (@percept_of W) b' = (t, e, z') -> size t <= b ->
  no_open_dart (log_of W t) -> right_in (size t0 + size t).
Proof.
move=> loops R0 EQ R lt nopen; have nopen' := guest_folds loops R0 R nopen.
have [t' Et] := explore_prefix R lt.
case R1: (explore G (rooted (@start W)) (@percept_of W) b [:: o] (@start W)) Et => [[t1 e1] z1] /= Et.
have [c2 [z2 [s [R2 _ _]]]] := 
  outing_makes (seen := [:: _]) (done := [::]) (loops _ (erefl _) _ _ _ R0) (erefl _) (erefl _) R1.
rewrite !exec_bind R0 exec_bind R2 in EQ; case R3: (exec (q c2) z2) EQ => [[c3 z3] s3] EQ.
apply: (right_when_folded EQ); rewrite Et.
  by rewrite !size_cat size_turned_first size_cat -!addnA leq_add2l leq_addr.
by rewrite takeD take_size_cat // drop_size_cat // -catA take_turned_first.
Qed.

(* ---- Nine times ---- *)
Lemma least_round (f : nat -> nat) C : (exists k, C <= f k) ->
  exists k, C <= f k /\ (k = 0 \/ exists2 j, k = j.+1 & f j < C).
Proof.
move=> ex; case: (ex_minnP ex) => k le min; exists k; split=> //.
case: k le min => [|j] le min; [by left | right; exists j => //].
by rewrite ltnNge; apply/negP => /min; rewrite ltnn.
Qed.

Lemma right_in_more l l' : l <= l' -> right_in l -> right_in l'.
Proof. by move=> le [b [t [e [z [R s V I]]]]]; exists b, t, e, z; split=> //; exact: leq_trans le. Qed.

Theorem shield_by_first b t e z : episode X (rooted (@start W)) (@percept_of W) b = (t, e, z) ->
  no_open_dart (log_of W t) -> right_in (9 * size t).
Proof.
move=> R nopen; have [|k [le least]] := @least_round (fun k => 2 ^ k.*2) (size t).
  by exists (size t); rewrite (leq_trans (ltnW (ltn_expl _ (ltnSn 1)))) // leq_exp2l // -addnn leq_addr.
have [c [z0 [t0 [R0 l0 _]]]] := rounds_from_start W k.
apply: (@right_in_more (size t0 + size t)).
  rewrite (mulnDl 8 1) mul1n leq_add2r.
  case: least l0 {le R0} => [->|[j -> lt]]; first by rewrite muln1 addn2 !ltnS leqn0 => /eqP->.
  rewrite doubleS !expnS !mulnA => /(leq_trans (leq_addr 2 _)) l0; apply: leq_trans l0 _.
  by apply: leq_mul => //; exact: ltnW.
apply: (by_guest _ R0 _ R le nopen (q := outing Y (2 ^ k.*2.+1) [:: o] [::]) (n := k.+1)).
  move=> V EV c1 z1 t1; rewrite -EV => R1; have [c2 [z2 [s2 [R2 _ D]]]] := rounds_from_start V k.
  by rewrite R1 in R2; case: R2 => -> -> _.
exact: exec_rounds.
Qed.

Theorem shield_by_second b t e z : episode Y (rooted (@start W)) (@percept_of W) b = (t, e, z) ->
  no_open_dart (log_of W t) -> right_in (9 * size t).
Proof.
move=> R nopen; have [|k [le least]] := @least_round (fun k => 2 ^ k.*2.+1) (size t).
  exists (size t); rewrite (leq_trans (ltnW (ltn_expl _ (ltnSn 1)))) // leq_exp2l //.
  by rewrite -addnn -addnS leq_addr.
have t_gt0 : 0 < size t by case: t nopen {R le least} => // /nothing_walked.
have [c [z0 [t0 [R0 l0 D0]]]] := rounds_from_start W k.
have [c1 [z1 [t1 [R1 l1 D1]]]] := outing_loops X (2 ^ k.*2) D0.
pose p := bind (rounds o k 0 0) (outing X (2 ^ k.*2) [:: o] [::]).
have Rp : exec p (@start W) = (c1, z1, t0 ++ t1) by rewrite exec_bind R0 R1.
apply: (@right_in_more (size (t0 ++ t1) + size t)).
  rewrite (mulnDl 8 1) mul1n leq_add2r size_cat.
  have {l0 l1} l : size t0 + size t1 + 2 <= 4 * 2 ^ k.*2.
    by rewrite addnAC (mulnDl 2 2) leq_add.
  case: least l {le R0 R1 Rp p} => [->|[j -> lt]].
    rewrite muln1 addn2 => /ltnW/ltnW l; apply: leq_trans l _.
    by apply: leq_trans (_ : 8 * 1 <= _) => //; exact: leq_mul.
  move/(leq_trans (leq_addr 2 _)) => l; apply: leq_trans l _.
  by rewrite doubleS expnS mulnA; apply: leq_mul => //; exact: ltnW.
apply: (by_guest _ Rp _ R le nopen (q := fun c => Return c) (n := k.+1)).
  move=> V EV c2 z2 t2; rewrite /p -EV exec_bind => R2.
  have [c3 [z3 [s3 [R3 _ D3]]]] := rounds_from_start V k; rewrite R3 in R2.
  have [c4 [z4 [s4 [R4 _ D4]]]] := outing_loops X (2 ^ k.*2) D3; rewrite R4 in R2.
  by case: R2 => <- <- _.
rewrite exec_rounds /p !exec_bind add0n; case: (exec (rounds o k 0 0) _) => [[c2 z2] t2].
rewrite /both_out exec_bind; case: (exec (outing X _ _ _ _) z2) => [[c3 z3] t3]; rewrite exec_bind_return.
by case: (exec (outing Y _ _ _ _) z3) => [[c4 z4] t4]; rewrite catA.
Qed.
End World.
End Shield.

(* ---- With Algorithm 1 ---- *)
Section WithAlgorithm1.
Variables (E : Type) (X : explorer percept E) (pol : policy) (W : lighthouse_world).
Local Notation shielded := (as_explorer (shield X (algorithm1 pol))).
Local Notation right_in limit := (right_within shielded (M := rooted (@start W)) (@percept_of W) limit).

Lemma algorithm1_moves k c : exists m f, both_out X (algorithm1 pol) (percept_of (@start W)) k c = Go m f.
Proof.
have := degree_gt0 (@start W); rewrite -[degree _]/((percept_of (@start W)).1).
move: (percept_of (@start W)) => o o1.
have [m Em] : exists m, algorithm1 pol [:: o] = Move m.
  rewrite /algorithm1 /explorer_by /= /act /= /first_knowledge /=.
  by case: o.1 o1 => //= n _; rewrite /one_pass; case: (way_to _ _ _).1 => [|j w] /=; eexists.
have go D c' : exists m f, outing (algorithm1 pol) (2 ^ D) [:: o] [::] c' = Go m f.
  by do 2 eexists; apply: outing_goes Em; rewrite expn_gt0.
rewrite /both_out; case ET: (outing X _ _ _ _) => [c'|m' f] /=; first exact: go.
by do 2 eexists.
Qed.

Theorem shield_of_folder b t e z : episode X (rooted (@start W)) (@percept_of W) b = (t, e, z) ->
  no_open_dart (log_of W t) -> right_in (9 * size t).
Proof. exact: (@shield_by_first _ _ X (algorithm1 pol) W algorithm1_moves). Qed.

Theorem shield_correct : right_in (9 * paper_bound (vertices W) (edges W)).
Proof.
have [t [e [z [R le V I]]]] := algorithm1_correct (W := W) pol (leqnn _).
have := @shield_by_second _ _ X (algorithm1 pol) W algorithm1_moves _ _ _ _ R (algorithm1_log_folds R).
by apply: right_in_more; rewrite leq_mul2l.
Qed.
End WithAlgorithm1.

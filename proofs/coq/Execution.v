(* ---------------------------------------------------------------------------------------------
   A program, run in a world.                                                          Section IV

     episode_machine      the explorer, which remembers all percepts, is the machine, which remembers its
                          program only.
     exec p d             program p, run in the world from dart d: its result, the robot's dart, the
                          transcript.
     makes p d x z n      run from dart d, program p gives x, at dart z, after n traversals.
     machine_exec         the machine executes programs.
     due c d x            a robot at d that turns by c is as if it had come in by x.
     trail done y x       the motions in done lead from x to y.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Explorers Algorithm.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The explorer that remembers everything is the machine that remembers its program only ---- *)
Section Remembering.
Variables (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Variables (M : rooted_map) (senses : carrier M -> O).
Local Notation machine := (machine L pol (motion_in M) senses).

Lemma explore_machine budget o seen d :
  explore (explorer_by L pol) M senses budget (o :: seen) d
  = machine budget (foldl (sense L pol) (set_out L o) seen) d.
Proof.
elim: budget seen d => [|n IH] seen d /=; rewrite /act; case E: (next L pol _) => [e|[k f]] //.
rewrite IH.
have -> : foldl (sense L pol) (set_out L o) (rcons seen (senses (motion_in M k d)))
    = f (senses (motion_in M k d)).
  by rewrite -cats1 foldl_cat /= /sense E.
by [].
Qed.

Theorem episode_machine budget :
  episode (explorer_by L pol) M senses budget
  = machine budget (set_out L (senses (root M))) (root M).
Proof. exact: explore_machine. Qed.
End Remembering.

(* ---- A program in a world ---- *)
Section Makes.
Variables (G : combinatorial_map) (O : Type) (senses : G -> O).
Local Notation program := (program O).

Fixpoint exec A (p : program A) (d : G) : A * G * seq (nat * O) :=
  match p with
  | Return x => (x, d, [::])
  | Go k f =>
      let: (x, z, t) := exec (f (senses (motion k d))) (motion k d) in
      (x, z, (k, senses (motion k d)) :: t)
  end.
Definition makes A (p : program A) d x z n := exists t, exec p d = (x, z, t) /\ size t = n.

Lemma makes_return A (x : A) d : makes (Return x) d x d 0.
Proof. by exists [::]. Qed.

Lemma makes_go A k (f : O -> program A) d x z n :
  makes (f (senses (motion k d))) (motion k d) x z n -> makes (Go k f) d x z n.+1.
Proof. by case=> t [E <-]; exists ((k, senses (motion k d)) :: t); rewrite /= E. Qed.

Lemma makes_bind A B (p : program A) (f : A -> program B) d x z n y z' n' :
  makes p d x z n -> makes (f x) z y z' n' -> makes (bind p f) d y z' (n + n').
Proof.
case=> t [E <-] F; elim: p d t E => [x'|k g IH] d t /=; first by case=> -> -> <-.
case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1; rewrite addSn; apply: makes_go.
exact: (IH _ _ _ E).
Qed.

Definition due c (d x : G) := iter c sigma d = x.

Lemma motion_due c d x k : due c d x -> motion (c + k) d = motion k x.
Proof. by move=> <-; rewrite /motion addnC iterD. Qed.

Lemma walk_to_makes w k c d x : due c d x ->
  makes (walk_to O w k c) d (senses (motion k (walk w x))) (motion k (walk w x)) (size w).+1.
Proof.
elim: w c d x => [|j w IH] c d x du /=; apply: makes_go; rewrite (motion_due _ du).
  exact: makes_return.
exact: IH.
Qed.

Fixpoint trail (done : seq (nat * nat)) (y x : G) :=
  if done is q :: done' then
    exists z, [/\ y = motion q.1 z, q.2 = degree z & trail done' z x]
  else y = x.

(* line 15: the robot retraces, coming back to v_u and resuming its orientation *)
Lemma go_back_makes done c d y x : due c d y -> trail done y x ->
  exists c' z, makes (go_back O done c) d c' z (size done) /\ due c' z x.
Proof.
elim: done c d y => [|[k n] done IH] c d y du /=.
  by move=> <-; exists c, d; split=> //; exact: makes_return.
case=> z [Y N T]; have E : motion c d = iter k sigma z.
  by rewrite -[c]addn0 (motion_due 0 du) Y /motion /= alphaK.
have [|c' [z' [A B]]] := IH (opposite n k) (motion c d) z _ T.
  by rewrite E N; exact: opposite_turn.
by exists c', z'; split=> //; exact: makes_go.
Qed.
End Makes.

(* ---- The machine executes programs ---- *)
Section Machine.
Variables (G : combinatorial_map) (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Variable senses : G -> O.
Local Notation machine := (machine L pol motion senses).

Lemma machine_next fuel p q d : next L pol p = next L pol q -> machine fuel p d = machine fuel q d.
Proof. by case: fuel => [|fuel] /= ->. Qed.

Lemma next_pass k : unexplored k != [::] -> next L pol (Return k) = next L pol (one_pass L pol k).
Proof.
rewrite /=; case E: (unexplored k) => // _.
by rewrite /one_pass; case: (way_to pol k (next_edge pol k)).1.
Qed.

Lemma machine_exec p d s z t fuel t' e z' :
  exec senses p d = (s, z, t) -> machine fuel (Return s) z = (t', Some e, z') ->
  machine (size t + fuel) p d = (t ++ t', Some e, z').
Proof.
move=> E F; elim: p d t E => [x|k g IH] d t; first by case=> -> -> <-.
rewrite [exec _ _ _]/=; case E: (exec _ _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1.
by rewrite [size _]/= addSn [Algorithm.machine _ _ _ _ _ _ _]/= (IH _ _ _ E).
Qed.
End Machine.

(* it does the same where the same is sensed *)
Lemma machine_ext (D O : Type) (B : eqType) (L : lighthouse O B) pol (moves : nat -> D -> D)
    (s1 s2 : D -> O) : s1 =1 s2 ->
  forall fuel p d, machine L pol moves s1 fuel p d = machine L pol moves s2 fuel p d.
Proof. by move=> E; elim=> //= fuel IH p d; case: (next L pol p) => // -[k f]; rewrite E IH. Qed.

(* once it has stopped, a larger budget changes nothing *)
Lemma machine_more (D O : Type) (B : eqType) (L : lighthouse O B) pol (moves : nat -> D -> D)
    (senses : D -> O) fuel more p d t e z : machine L pol moves senses fuel p d = (t, Some e, z) ->
  machine L pol moves senses (fuel + more) p d = (t, Some e, z).
Proof.
elim: fuel p d t => [|fuel IH] p d t.
  by rewrite add0n; case: more => [|more] /=; case: (next L pol p) => // -[].
rewrite addSn /=; case: (next L pol p) => // -[k f].
case R: (machine _ _ _ _ fuel _ _) => [[t' [e'|]] z'] //= [<- ee zz]; subst e' z'.
by rewrite (IH _ _ _ R).
Qed.

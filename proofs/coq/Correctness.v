(* ---------------------------------------------------------------------------------------------
   The theorem of the paper, for every schedule.                             Sections IV, V and VI

     map_with_robot S h   S without open darts as a rooted map: its darts are the known darts, the
                          root is the robot's dart h.
     robot_knows c        the map is the world and the robot knows where it is: S, seen from the
                          dart where the robot believes to be, is the world seen from its true
                          dart.

     run_invariant        I-1 and I-2 hold after every pass of every run.
     run_tests            every test decides its hypothesis.
     run_progress         while a dart is open the run goes on.
     run_correct          a run that has no open dart left has made exactly m passes, with at most
                          (1)+(2) traversals; the map is the world and the pose is right.
     run_ends             every run can be continued to such an end, and none makes more than m
                          passes.
     run_cost_O_m2n       at no time has a run made more than 2 m^2 n traversals.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps PartialMaps HypothesisTests Pass Cost.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition map_with_robot S (h : dart) :=
  @RootedMap dart (known S) (turn S 1) (fun e => odflt e (partner S e)) h.

Section Correctness.
Variable W : lighthouse_world.
Implicit Type c : configuration W.
Local Notation v0 := (@start W).

Definition nothing_open c := forall e, ~~ is_open (mapped c) e.
Definition robot_knows c := isomorphic (map_with_robot (mapped c) (here c)) (rooted (robot c)).

Lemma run_embedded n C c : reached n C c -> exists r,
  [/\ embedded v0 (mapped c) r, known (mapped c) (here c) & robot c = phi v0 r (here c)].
Proof. by move/reached_sound=> [r [I kh ph _]]; exists r. Qed.

Theorem run_invariant n C c : reached n C c -> exists r,
  [/\ I1 v0 (mapped c) r, I2 v0 (mapped c) r, known (mapped c) (here c)
    & robot c = phi v0 r (here c)].
Proof.
move/run_embedded=> [r [I kh ph]]; exists r; split=> //; [exact: invariant_I1 | exact: invariant_I2].
Qed.

Theorem run_tests n C c : reached n C c -> exists2 r, I1 v0 (mapped c) r & forall w h f,
  known (mapped c) h -> follow (mapped c) w h = Some f -> f.1 = 0 ->
    (forall x : W, percepts_along w x = expected_percepts (first_bearing W) (mapped c) w h
                   <-> x = phi v0 r h) /\
    (forall h' f', known (mapped c) h' -> follow (mapped c) w h' = Some f' ->
       expected_percepts (first_bearing W) (mapped c) w h
       = expected_percepts (first_bearing W) (mapped c) w h' -> h = h').
Proof.
move/run_embedded=> [r [I _ _]]; exists r; first exact: invariant_I1.
move=> w h f kh R f0; split=> [x|h' f' kh' R' E].
  exact: (test_iff I x kh R f0).
exact: (embedded_path_unique I kh kh' R f0 R' E).
Qed.

Lemma run_passes n C c : reached n C c -> n <= edges W.
Proof.
move=> R; have [r [I _ _]] := run_embedded R; rewrite -leq_double edges_double -(reached_links R).
exact: (size_links I).
Qed.

Theorem run_progress n C c e : reached n C c -> is_open (mapped c) e -> exists C' c', pass e c C' c'.
Proof. by move/reached_sound; exact: pass_progress. Qed.

(* S without open darts, embedded by phi, is the world *)
Lemma complete_isomorphic S r h : embedded v0 S r -> complete_map v0 S r -> known S h ->
  isomorphic (map_with_robot S h) (rooted (phi v0 r h)).
Proof.
move=> I [sur inj trn lnk _] kh.
pose g x := nth h (darts S) (find (fun e => phi v0 r e == x) (darts S)).
have gP x : known S (g x) /\ phi v0 r (g x) = x.
  have hx : has (fun e => phi v0 r e == x) (darts S).
    by have [e ke <-] := sur x; apply/hasP; exists e; rewrite ?mem_darts.
  by split; [rewrite -mem_darts mem_nth // -has_find | apply/eqP; exact: (nth_find h hx)].
exists (phi v0 r), g; split=> //= e ke.
have [kg E] := gP (phi v0 r e); split=> //; [exact: inj | exact: trn|].
by have [f [-> _ <-]] := lnk e ke.
Qed.

Theorem run_correct n C c : reached n C c -> nothing_open c ->
  [/\ n = edges W, C <= paper_bound (vertices W) (edges W) & robot_knows c].
Proof.
move=> R nopen; have [r [I kh ph]] := run_embedded R.
have X := complete_when_nothing_open I nopen.
have E : n = edges W.
  apply: double_inj; rewrite edges_double; apply/eqP.
  by rewrite eqn_leq -(reached_links R) (size_links I) (complete_links X).
split=> //; last by rewrite /robot_knows ph; exact: complete_isomorphic.
have n0 : 0 < vertices W by exact: (vertices_gt0 v0).
rewrite -run_bound_paper //; first by rewrite -[X in run_bound _ _ X]E; exact: run_cost R.
by rewrite -E leq_subLR add1n (leq_trans (complete_vertices I X)) // (reached_size R).
Qed.

Theorem run_completes n C c : reached n C c -> exists C' c',
  [/\ reached (edges W) C' c', nothing_open c' & C <= C'].
Proof.
have [N] := ubnP (edges W - n); elim: N n C c => // N IH n C c lN R.
case: (boolP (has (fun e => is_open (mapped c) e) (darts (mapped c)))) => [/hasP[e _ oe]|/hasPn H].
  have [C1 [c1 P]] := pass_progress (reached_sound R) oe; have R1 := ReachedPass R P.
  have [|C' [c' [R' nopen le]]] := IH _ _ _ _ R1.
    by rewrite ltnS in lN; apply: leq_trans lN; by apply: ltn_sub2l => //; exact: (run_passes R1).
  by exists C', c'; split=> //; apply: leq_trans le; exact: leq_addr.
have nopen : nothing_open c.
  move=> e; apply/negP=> oe; have [ke _] := andP oe.
  by have := H e; rewrite mem_darts oe => /(_ ke).
by have [<- _ _] := run_correct R nopen; exists C, c.
Qed.

Corollary run_ends n C c : reached n C c ->
  n <= edges W /\ exists C' c', [/\ reached (edges W) C' c', nothing_open c' & C <= C'].
Proof. by move=> R; split; [exact: run_passes R | exact: run_completes R]. Qed.

Corollary run_cost_O_m2n n C c : reached n C c -> C <= 2 * edges W ^ 2 * vertices W.
Proof.
case/run_completes=> C' [c' [R nopen le]]; apply: leq_trans le _.
have [_ le _] := run_correct R nopen; apply: leq_trans le _.
have [r [I _ _]] := run_embedded R; have X := complete_when_nothing_open I nopen.
apply: paper_bound_le; first exact: (vertices_gt0 v0).
by rewrite leq_subLR add1n (leq_trans (complete_vertices I X)) // (reached_size R).
Qed.
End Correctness.

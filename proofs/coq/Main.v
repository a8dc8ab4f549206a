(* ---------------------------------------------------------------------------------------------
   Exploring topological worlds with minimal information: the main theorems.

   The words are those of Model.v, definitions only: worlds (combinatorial_map, lighthouse_world), motions,
   percepts, explorers, and when an explorer is `right` (its answer is the map, with its place in it) or
   `finds_map` (its answer is the map).  What no explorer can do is said of finding the map, and so of all
   explorers: with a seed or an oracle, one for each seed; what Algorithm 1 does, of being right.
   These are explained here:

   no_explorer_maps_both senses M N: no_explorer_finds_both for worlds given by lists of numbers.
   position_percept: the degree, and whether the vertex is the one where the robot started.
   policy: four functions of all that the program knows, one for each choice that Algorithm 1 leaves open
   (the edge, the path to it, the order of the tests, the path of a test); an illegal choice is replaced.

   `reached n C c`: some run of Algorithm 1 is in configuration c after n passes and C traversals.  All
   choices that the paper leaves open are left open here.  mapped c is S, here c the robot's dart in S,
   robot c its true dart; known S e: e is a dart of a vertex of S; is_open S e: e is in U.
   phi start r: the paper's phi, from the darts of S to those of G; r lists, for each vertex of S, the
   dart of G where the count of its darts begins.  map_with_robot S h: S as a map, seen from its dart h.

   resumption S O: an explorer that keeps a state of type S between percepts of type O; as_explorer r: the
   function of the percepts that it is.  right_within X M senses limit: X stops after at most `limit`
   motions, with the right answer.  directional_check: the program.  All four in Checker.v.
   branches: what is done after which percepts, written down as a decision tree (Node k after: make motion k,
   Leaf e: answer e); answers_as X tree: the explorer X does so, wherever the tree says what is done.
   certified: the checker, for the tree.  Both in DecisionTrees.v.

   sensor A: what a robot with a marked dart, the door, may sense: for each map, door and dart a letter of
   type A.  percept_by lambda: the degree and the letter of the sensor lambda.  at_v0 w: the sensor that shows
   w d b where the degree is d and the door b darts further clockwise, and 0 elsewhere; word w d is the word
   w d 0 ... w d (d-1).  invariant lambda: isomorphisms change no letter, as letters_are_invariant in
   Further.v says of at_v0 w.  All in Sensors.v.  A word is primitive if it is no proper power, blank if all its
   letters are 0 (Words.v).

   Further.v has the other theorems.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Pass Cost.
From Allworlds Require Import Correctness Algorithm Refinement Impossibility Twins Log OpenDarts.
From Allworlds Require Import LowerBounds Cluster Checker DecisionTrees Words Sensors OneBit Door Mapping.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ==== What no explorer can do (Section III) ==== *)

(* No information: every vertex of a cycle has degree 2, and nothing else is sensed.  Cycles of two
   lengths; `side` is the side that the robot faces first. *)
Theorem no_information_is_not_enough n n' side : 0 < n -> 0 < n' -> n <> n' ->
  no_explorer_finds_both (M := cycle_world n side) (N := cycle_world n' side)
    (fun _ => 2) (fun _ => 2).
Proof. exact: (@cycles_impossible _ (fun=> 2)). Qed.

(* Orientation without position: the robot senses also which side it came in by. *)
Theorem orientation_is_not_enough n n' side : 0 < n -> 0 < n' -> n <> n' ->
  no_explorer_finds_both (M := cycle_world n side) (N := cycle_world n' side)
    (fun d => (2, d.2)) (fun d => (2, d.2)).
Proof. exact: (@cycles_impossible _ (pair 2)). Qed.

(* Position without orientation: pairs of worlds with 2 edges, with 6 (simple), with 8 (simple and
   planar), and a simple planar pair that has everything the caption of Fig. 1 fixes. *)
Theorem position_is_not_enough :
  [/\ no_explorer_maps_both position_percept two_loops_plane two_loops_torus,
      no_explorer_maps_both position_percept k4_plane k4_torus,
      no_explorer_maps_both position_percept hexagon triangles &
      no_explorer_maps_both position_percept figure_1_left figure_1_right].
Proof. exact: And4 two_loops_impossible k4_impossible hexagon_impossible figure_1_impossible. Qed.

(* ==== Algorithm 1 with a directional lighthouse (Sections IV, V and VI) ==== *)

(* The explorer, under every policy for the choices left open (first in first out, last in first out and
   nearest dart are three): given at least (1) + (2) motions it stops within (1) + (2), with the right
   answer.  denote: the rooted map that an answer stands for. *)
Theorem explorer_correct (pol : policy) (W : lighthouse_world) budget :
  paper_bound (vertices W) (edges W) <= budget -> exists transcript answer z,
  [/\ episode (algorithm1 pol) (rooted start) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= paper_bound (vertices W) (edges W),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. exact: algorithm1_correct. Qed.

(* The relation, for every schedule.  After every pass: I-1, S is isomorphic to the explored subgraph;
   I-2, U is the set of the unexplored darts at its vertices; the robot is where it believes to be. *)
Theorem invariant_holds (W : lighthouse_world) n C (c : configuration W) : reached n C c ->
  exists r, [/\ I1 start (mapped c) r, I2 start (mapped c) r,
                known (mapped c) (here c) & robot c = phi start r (here c)].
Proof. exact: run_invariant. Qed.

(* When U is empty exactly m passes were made, with at most (1) + (2) traversals; S is the world and the
   robot knows its place in it.  Every run can be continued to such an end. *)
Theorem correct_when_done (W : lighthouse_world) n C (c : configuration W) : reached n C c ->
  (forall e, ~~ is_open (mapped c) e) ->
  [/\ n = edges W, C <= paper_bound (vertices W) (edges W) &
      isomorphic (map_with_robot (mapped c) (here c)) (rooted (robot c))].
Proof. exact: run_correct. Qed.

Theorem runs_end (W : lighthouse_world) n C (c : configuration W) : reached n C c ->
  n <= edges W /\ exists C' (c' : configuration W),
    [/\ reached (edges W) C' c', forall e, ~~ is_open (mapped c') e & C <= C'].
Proof. exact: run_ends. Qed.

(* (1) + (2) is O(m^2 n). *)
Theorem cost_is_O_m2n (W : lighthouse_world) n C (c : configuration W) :
  reached n C c -> C <= 2 * edges W ^ 2 * vertices W.
Proof. exact: run_cost_O_m2n. Qed.

(* ==== The extracted checker ==== *)

(* Any explorer, as a function of its percepts (as_explorer r), and any limit on its motions, a function of
   n, m and deg(v0): `check` says true if and only if the explorer stops within the limit, with the right
   answer, in every world, or every simple world, with at most m edges. *)
Theorem checker_is_right S (r : resumption S percept) limit u m :
  directional_check r limit u m <->
  forall W : lighthouse_world, in_universe u W -> edges W <= m ->
  right_within (as_explorer r) (M := rooted (@start W)) (@percept_of W)
    (limit (vertices W) (edges W) (degree (@start W))).
Proof. exact: directional_check_correct. Qed.

(* A certificate: what a program does after which percepts, written down as a decision tree.  The kernel
   computes `certified`; then every explorer that answers as the tree, and so the program, is right in every
   world with at most m edges.  The worlds are not written down: they are those of the theorem above. *)
Theorem certificate_is_right (tree : branches) limit u m :
  certified tree limit u m <->
  forall X : explorer percept numbered_map, answers_as X tree ->
  forall W : lighthouse_world, in_universe u W -> edges W <= m ->
  right_within X (M := rooted (@start W)) (@percept_of W)
    (limit (vertices W) (edges W) (degree (@start W))).
Proof. exact: certified_right. Qed.

(* ==== Every explorer with a directional lighthouse (Sections V and VI) ==== *)

(* An explorer that finds the map of every world, or of every simple world: what it has sensed when it
   stops is a proof of its answer.  Its log (the percepts and motions) is folded: darts that every world
   with this log must have as one dart are made one.  Then every dart has a known other end, none is
   open, so one world only agrees with the log (folded_log_is_the_world in Further.v). *)
Theorem log_of_a_right_explorer_folds u E (meaning : E -> rooted_map) (X : explorer percept E) :
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) -> no_open_dart (log_of W t).
Proof. exact: explorer_log_folds. Qed.

(* Omega(mn): a world with m = 2(k+1) and n = k+2, for every k, where no such explorer does with fewer
   than m (n-1) motions: one world for all explorers. *)
Theorem quadratic_lower_bound k : exists W : lighthouse_world,
  [/\ edges W = k.+1.*2, vertices W = k.+2 &
  forall E (meaning : E -> rooted_map) (X : explorer percept E), finds_all_maps AllWorlds meaning X ->
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W * (vertices W - 1) <= size t].
Proof. exact: mn_lower_bound. Qed.

(* The same where the worlds are known to be simple, and are dense: n = 2q and m = q(q+1)/2. *)
Theorem quadratic_lower_bound_in_simple_worlds q : 7 <= q -> exists W : lighthouse_world,
  [/\ simple_world W, edges W = 'C(q.+1, 2), vertices W = q.*2 &
  forall E (meaning : E -> rooted_map) (X : explorer percept E), finds_all_maps SimpleWorlds meaning X ->
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W * vertices W <= 2 * size t].
Proof. exact: mn_lower_bound_simple. Qed.

(* ==== Another lighthouse: undirected markers (Sections IV and VIII) ==== *)

(* One marker at v0, two at v1, no direction: v1 is the vertex at the other end of `pointed`, which now
   says only where the two markers lie.  one_edge W: no other dart of v0 leads to v1, and v1 is not v0.
   cluster_percept: the degree and the number of markers.  The robot looks for that edge first, at most
   2 deg(v0) traversals, and at the end of each test leaves by the dart that should lead to v1, looks,
   and comes back.  cluster_bound W: (1) + (2) + 2 m^2, which is two traversals for each test. *)
Theorem cluster_is_right (W : lighthouse_world) : one_edge W -> forall (pol : policy) budget,
  2 * degree (@start W) + cluster_bound W <= budget -> exists transcript answer z,
  [/\ episode (cluster_algorithm pol) (rooted (@start W)) (@cluster_percept W) budget
        = (transcript, Some answer, z),
      size transcript <= 2 * degree (@start W) + cluster_bound W,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> H pol budget; exact: cluster_correct. Qed.

(* ==== What a marker has to tell (Section III) ==== *)

(* sufficient lambda: any two worlds that a bisimulation relates, under which degrees and letters agree, are
   the same map with the same start (Sensors.v).  A sensor is sufficient if and only if a robot that has it can
   map every world, once it knows a bound on the number of edges. *)
Theorem to_suffice_is_to_be_enough (A : eqType) (lambda : sensor A) : invariant lambda ->
  sufficient lambda <-> forall m, exists X : explorer (nat * A) numbered_map,
  forall W : lighthouse_world, edges W <= m ->
  right denote X (rooted (@start W)) (percept_by lambda (W := W)).
Proof. exact: sufficient_iff_mapped. Qed.

(* A sensor that looks at v0 alone is sufficient if and only if its word for each degree is primitive and not
   blank. *)
Theorem sensors_that_suffice w : sufficient (at_v0 w) <->
  forall d, 0 < d -> primitive (word w d) /\ ~~ blank (word w d).
Proof. exact: sensor_iff. Qed.

(* One bit is enough: the door, sensed only by who comes in by it, with the words 1 0 ... 0.  It is minimal:
   nothing that is strictly coarser is sufficient.  The directional lighthouse, with the words 1 2 ... d, is not
   minimal. *)
Theorem one_bit_is_enough :
  [/\ sufficient (at_v0 door_word), minimal (at_v0 door_word) & ~ minimal (at_v0 directional_word)].
Proof. exact: And3 door_suffices door_minimal directional_not_minimal. Qed.

(* And with this bit Algorithm 1 is right.  The robot looks for the door first, two traversals for each dart
   of v0 up to it; at the end of each test it leaves by the dart that should be the door and comes back: the
   bit is 1 if and only if the hypothesis is true.  door_bound W: (1) + (2) + 2 m^2, which is two traversals
   for each test. *)
Theorem door_is_right (pol : policy) (W : lighthouse_world) budget :
  2 * first_bearing W + door_bound W <= budget -> exists transcript answer z,
  [/\ episode (door_algorithm pol) (rooted (@start W)) (percept_by (at_v0 door_word) (W := W)) budget
        = (transcript, Some answer, z),
      size transcript <= 2 * first_bearing W + door_bound W,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. exact: door_correct. Qed.

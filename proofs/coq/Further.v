(* ---------------------------------------------------------------------------------------------
   The theorems that do not stand in Main.v, section by section.  The words are explained there, in
   Model.v, and at the head of the files named in README.md.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Features WeakestSensors.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import PartialMaps Paths Pass Cost Correctness PassCounts Lighthouses Routes.
From Allworlds Require Import Algorithm Execution OnePass Refinement Policies ShortestPaths.
From Allworlds Require Import NumberedWorlds Judge Impossibility DoubleCover Trees PositionTwins.
From Allworlds Require Import Ambiguity Regluing RegluingCount MassFormula Twins Congruence Log
  Folding OpenDarts.
From Allworlds Require Import PathWorlds Cycles LowerBounds Enumeration TwoVertices Cluster.
From Allworlds Require Import Carrying Laying MovableMarker.
From Allworlds Require Import NaturalLighthouse FoldingProgram SameWorld Checker TwoVerticesChecker.
From Allworlds Require Import Shield DecisionTrees Words Sensors OneBit Door Scan Elsewhere.
From Allworlds Require Import Minimality PlanarMinimality.
From Allworlds Require SensorTwins.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ==== Motion (Section II.B) ==== *)

(* Motions can be undone, by as many motions and a turn; and equal motions lead different darts to
   different darts. *)
Theorem motion_is_reversible (G : combinatorial_map) (w : seq nat) :
  (forall d : G, exists v j, size v = size w /\ iter j sigma (walk v (walk w d)) = d) /\
  injective (@walk G w).
Proof. exact: conj (motions_undone w) (@walk_inj G w). Qed.

(* ==== Algorithm 1, for every schedule (Sections IV and V) ==== *)

(* A hypothesis h, tested by a path w from h to v0 in S, matches throughout if and only if it is true;
   and the motions of such a path with the percepts expected on it belong to one dart only. *)
Theorem tests_decide (W : lighthouse_world) n C (c : configuration W) : reached n C c ->
  exists2 r, I1 start (mapped c) r & forall w h f,
    known (mapped c) h -> follow (mapped c) w h = Some f -> f.1 = 0 ->
    (forall x : W, percepts_along w x = expected_percepts (first_bearing W) (mapped c) w h
                   <-> x = phi start r h) /\
    (forall h' f', known (mapped c) h' -> follow (mapped c) w h' = Some f' ->
       expected_percepts (first_bearing W) (mapped c) w h
       = expected_percepts (first_bearing W) (mapped c) w h' -> h = h').
Proof. exact: run_tests. Qed.

(* While a dart is open it can be explored, and every pass makes t = m - |E_S| smaller by one. *)
Theorem never_stuck (W : lighthouse_world) n C (c : configuration W) e : reached n C c ->
  is_open (mapped c) e -> exists C' c', pass e c C' c'.
Proof. exact: run_progress. Qed.

Theorem variant_falls (W : lighthouse_world) n C (c : configuration W) e C' c' : reached n C c ->
  pass e c C' c' -> variant c = (variant c').+1.
Proof. exact: pass_decreases_variant. Qed.

(* ==== Algorithm 1, as an explorer ==== *)

Theorem explorer_right (W : lighthouse_world) (pol : policy) :
  right denote (algorithm1 pol) (rooted start) (@percept_of W).
Proof. exact: algorithm1_right. Qed.

(* Where a policy proposes no path of its own the path taken is a shortest one in S; and `nearest`
   explores an open dart with the shortest way to it. *)
Theorem paths_are_shortest S a w f : known S a ->
  (forall x y, partner S x = Some y -> known S y) ->
  follow S w a = Some f -> let way := route S a f.1 in
  [/\ follow S way.1 a = Some way.2, way.2.1 = f.1 & size way.1 <= size w].
Proof.
move=> ka kl R /=; have J : joined S a f.1 by exists w, f.
by have [A B _] := routeP ka kl J; split=> //; exact: (route_shortest ka kl R).
Qed.

Theorem nearest_takes_the_nearest k : unexplored k != [::] ->
  next_edge nearest k \in unexplored k /\
  forall e, e \in unexplored k -> distance k (next_edge nearest k) <= distance k e.
Proof. exact: nearest_is_nearest. Qed.

(* What is computed and extracted: the same for worlds written down as lists of numbers, (1) + (2) computed
   too; k: the bearing of the marker at the root. *)
Theorem explorer_correct_in_numbers (pol : policy) (M : numbered_map) k budget :
  valid M -> size (dart_order M) == size (sigma_list M) ->
  let limit := paper_limit (vertices_in M) (edges_in M) in limit <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (denote M) (directional_senses M k) budget
        = (transcript, Some answer, z),
      size transcript <= limit & same_code answer (seen_from M z)].
Proof. exact: algorithm1_within. Qed.

(* What runs outside Coq, one step at a time without remembering the percepts, is that explorer, with
   each of the lighthouses. *)
Theorem machine_is_explorer O B (L : lighthouse O B) (pol : policy) (M : rooted_map)
    (senses : carrier M -> O) budget :
  episode (explorer_by L pol) M senses budget
  = machine L pol (motion_in M) senses budget (set_out L (senses (root M))) (root M).
Proof. exact: episode_machine. Qed.

(* Each pass of the program is a pass of the relation, with the same traversals. *)
Theorem program_is_an_instance (W : lighthouse_world) (pol : policy) k c d :
  sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes (@percept_of W) (one_pass directional pol k) d k' z n,
    pass (next_edge pol k) c n c' & knows k' c' z].
Proof. exact: one_pass_is_pass. Qed.

(* ==== Cost (Section VI) ==== *)

(* (1) + (2), exactly: 2m^2 n - 2mn^2 + (2/3)n^3 - 2m^2 + 5mn - (5/2)n^2 - 2m + (11/6)n. *)
Theorem bound_is_polynomial n m : 0 < n -> n - 1 <= m ->
  6 * paper_bound n m + 12 * m * n ^ 2 + 12 * m ^ 2 + 15 * n ^ 2 + 12 * m
  = 12 * m ^ 2 * n + 4 * n ^ 3 + 30 * m * n + 11 * n.
Proof. exact: paper_bound_polynomial. Qed.

(* n-1 passes find a vertex and m-n+1 close a loop, whatever the schedule.  counted v l C c: a run in
   which v passes have found a vertex and l have closed a loop, C traversals in all. *)
Theorem passes_of_both_kinds (W : lighthouse_world) (c : configuration W) :
  (forall n C, reached n C c <-> exists v l, counted v l C c /\ v + l = n) /\
  forall v l C, counted v l C c -> nothing_open c ->
  v.+1 = vertices W /\ l + vertices W = (edges W).+1.
Proof. by split=> [n C|v l C]; [exact: reached_counted | exact: passes_of_each_kind]. Qed.

(* '2m is a lower bound' is false: on every cycle, of k+1 vertices, Algorithm 1 walks exactly m edges if
   it takes the dart that came last first. *)
Theorem m_is_enough_on_cycles k b : let W := ring k b in
  edges W = k.+1 /\ vertices W = k.+1 /\ forall budget, edges W <= budget -> exists t answer z,
  [/\ episode (algorithm1 lifo) (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z),
      size t = edges W, valid answer & isomorphic (denote answer) (rooted z)].
Proof. by split; [exact: edges_ring | split; [exact: vertices_ring | exact: lifo_on_ring]]. Qed.

(* ==== Answers ==== *)

(* Equality of codes decides whether two rooted maps are the same. *)
Theorem same_map_decided M N : valid M -> valid N -> connected (denote M) ->
  reflect (isomorphic (denote M) (denote N)) (same_code M N).
Proof. exact: same_codeP. Qed.

(* The judge: right if and only if the answer e is the world M seen from the robot's dart z. *)
Theorem judge_correct M e z : valid M -> connected (denote M) -> z < size (sigma_list M) ->
  size (alpha_list e) = size (sigma_list e) ->
  [/\ judge M z e = IsRight <-> is_world_from M e z,
      judge M z e = WrongPose <->
        ~ is_world_from M e z /\ exists2 d, d < size (sigma_list M) & is_world_from M e d
    & judge M z e = WrongMap <-> forall d, d < size (sigma_list M) -> ~ is_world_from M e d].
Proof. by move=> V C l s; split; [exact: judge_right | exact: judge_pose | exact: judge_map]. Qed.

(* ==== Impossibility (Section III) ==== *)

(* The cycles of Main.v are connected maps, with two darts at each vertex. *)
Theorem cycles_are_worlds n side : 0 < n ->
  [/\ wellformed (cycle_world n side), connected (cycle_world n side) &
      forall d, sigma_of (cycle_world n side) (sigma_of (cycle_world n side) d) = d /\
                sigma_of (cycle_world n side) d <> d].
Proof. by move=> n0; split; [exact: cycle_wellformed | exact: cycle_connected | exact: cycle_degree]. Qed.

(* Two worlds related by a bisimulation R: an explorer that is right in both exists only if they are the
   same, place included; one that finds both maps only if they are the same map. *)
Theorem twins_cannot_both_be_explored P E (meaning : E -> rooted_map) (X : explorer P E)
    (M N : rooted_map) (sensesM : carrier M -> P) (sensesN : carrier N -> P)
    (R : carrier M -> carrier N -> Prop) :
  (forall x y, R x y -> sensesM x = sensesN y) ->
  (forall x y, R x y -> R (sigma_of M x) (sigma_of N y)) ->
  (forall x y, R x y -> R (alpha_of M x) (alpha_of N y)) ->
  R (root M) (root N) -> wellformed M -> wellformed N ->
  (right meaning X M sensesM -> right meaning X N sensesN -> isomorphic M N) /\
  (finds_map meaning X M sensesM -> finds_map meaning X N sensesN -> same_map M N).
Proof. by move=> Ro Rs Ra R0 WM WN; split; [exact: (twins_impossible Ro) | exact: (twins_same_map Ro)]. Qed.

(* Whoever is right finds the map. *)
Theorem being_right_is_more P E (meaning : E -> rooted_map) (X : explorer P E) M (obs : carrier M -> P) :
  right meaning X M obs -> finds_map meaning X M obs.
Proof. exact: right_finds_map. Qed.

(* Chance does not help.  An explorer with a seed, or with an oracle, is a family of explorers, one for
   each seed; where no explorer finds both maps, the seeds with which it finds the one and those with
   which it finds the other weigh together at most as much as all seeds: in one of the two worlds it
   fails with a probability of at least one half. *)
Theorem randomness_does_not_help P (M N : rooted_map) (sM : carrier M -> P) (sN : carrier N -> P)
    E (meaning : E -> rooted_map) (Seed : finType) (weight : Seed -> nat) (X : Seed -> explorer P E)
    (A B : {set Seed}) : no_explorer_finds_both sM sN ->
  (forall s, s \in A -> finds_map meaning (X s) M sM) ->
  (forall s, s \in B -> finds_map meaning (X s) N sN) ->
  \sum_(s in A) weight s + \sum_(s in B) weight s <= \sum_s weight s.
Proof. exact: seeds_do_not_help. Qed.

(* A directional lighthouse leaves no such pair: what no motion tells apart is the same. *)
Theorem lighthouse_leaves_no_twins (W W' : lighthouse_world) (R : W -> W' -> Prop) :
  (forall x y, R x y -> percept_of x = percept_of y) ->
  (forall x y, R x y -> R (sigma x) (sigma y)) -> (forall x y, R x y -> R (alpha x) (alpha y)) ->
  R start start -> isomorphic (rooted (@start W)) (rooted (@start W')).
Proof. exact: directional_unambiguous. Qed.

(* Without position, every world with a cycle through e: it and its double cover look the same, whether
   the robot senses degrees only or has an orientation at every vertex too.  The double cover of a simple
   world is simple. *)
Theorem no_world_with_a_cycle_without_position (G : combinatorial_map) (e : G) (cycle : on_cycle e)
    (d : G) (ref : pred G) :
  let H := double_cover cycle in
  [/\ no_explorer_finds_both (M := rooted d) (N := rooted ((d, false) : H))
        (@degree_sensed G) (@degree_sensed H),
      no_explorer_finds_both (M := rooted d) (N := rooted ((d, false) : H))
        (compass ref) (@compass H (fun p => ref p.1))
    & simple_world G -> simple_world H].
Proof. by have [A B] := world_with_cycle_impossible cycle d ref; split=> //; exact: cover_simple. Qed.

(* Trees, and only trees, can be explored without position.  Dead reckoning: Algorithm 1, sensing in its
   mind the lighthouse that is not there, is right in every tree; and a world is a tree if and only if no
   other world gives the same percepts, degrees, on every list of motions. *)
Theorem trees_without_position pol (G : combinatorial_map) (d : G) : acyclic G ->
  right denote (without_position (algorithm1 pol)) (rooted d) (@degree_sensed G).
Proof. exact: tree_explored. Qed.

Theorem only_trees_without_position (G : combinatorial_map) (d : G) : (forall e : G, ~~ on_cycle e) <->
  forall (H : combinatorial_map) (d' : H),
  (forall w, percepts_in (M := rooted d) (@degree G) w d
           = percepts_in (M := rooted d') (@degree H) w d') ->
  isomorphic (rooted d) (rooted d').
Proof. exact: tree_iff_no_twin. Qed.

(* With position, cycles of different length are told apart: one explorer is right on all of them. *)
Theorem cycles_with_position n side : 0 < n ->
  right (fun n => cycle_world n true) round_once (cycle_world n side) position_on_cycle.
Proof. exact: round_once_right. Qed.

(* ==== No smaller pairs (Section III) ==== *)

(* look_alike d e: position only, and every list of motions gives equal percepts from d and from e.  Then
   the two worlds are of one size. *)
Theorem lookalikes_have_one_size (G H : combinatorial_map) (d : G) (e : H) : look_alike d e ->
  [/\ edges G = edges H, vertices G = vertices H, degree d = degree e &
      forall k, #|[pred x : G | degree x == k]| = #|[pred y : H | degree y == k]|].
Proof.
move=> A; split; [exact: alike_edges A|exact: alike_vertices A|exact: alike_degree A|].
exact: alike_degrees A.
Qed.

(* So there is no pair of different worlds with one edge, of simple ones with at most 5, of simple planar
   ones with at most 7: the pairs of position_is_not_enough with 2, 6 and 8 edges are smallest ones.
   Planar worlds: the same map, v0 on v0, but not always the same dart first. *)
Theorem no_smaller_pairs (G H : combinatorial_map) (d : G) (e : H) : look_alike d e ->
  [/\ edges G <= 1 -> isomorphic (rooted d) (rooted e),
      simple_world G -> simple_world H -> edges G <= 5 -> isomorphic (rooted d) (rooted e) &
      simple_world G -> simple_world H -> planar_map G -> planar_map H -> edges G <= 7 ->
      exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e')].
Proof.
move=> A; split; [exact: no_twins_with_one_edge A|exact: no_simple_twins A|].
by move=> sG sH pG pH; exact: no_planar_twins A.
Qed.

(* Ten motions, the same in all of them, tell the simple worlds with at most 5 edges apart; 47 the simple
   planar ones with at most 7. *)
Theorem one_walk_tells_small_worlds_apart (G H : combinatorial_map) (d : G) (e : H) :
  simple_world G -> simple_world H ->
  (edges G <= 5 -> edges H <= 5 -> walk_alike d e simple_walk -> isomorphic (rooted d) (rooted e)) /\
  (planar_map G -> planar_map H -> edges G <= 7 -> edges H <= 7 -> walk_alike d e planar_walk ->
   exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e')).
Proof. by move=> sG sH; split; [exact: simple_worlds_differ | exact: planar_worlds_differ]. Qed.

(* ==== Which worlds are ambiguous with position only (Section III) ==== *)

(* Darts of one world that no motions tell apart, position sensed: the darts fall into classes of one size,
   k = lookalikes d, which divides the degree of v0.  cone x: how many darts of its class lie at the vertex
   of x; class_vertices x: the vertices of the class. *)
Theorem classes_of_lookalikes (G : combinatorial_map) (d x : G) :
  let senses := position_of d in
  [/\ #|class senses x| = lookalikes d, #|G| = #|classes senses| * lookalikes d,
      lookalikes d %| degree d, cone senses x %| degree x
    & lookalikes d = #|class_vertices senses x| * cone senses x].
Proof.
split; [exact: class_size|exact: darts_by_classes|exact: lookalikes_degree|exact: cone_degree|].
by rewrite -(cone_size (@position_degree G d)); exact: class_size.
Qed.

(* A class that contains the other end of one of its darts has an even number of darts. *)
Theorem crossed_classes_are_even (G : combinatorial_map) (d x : G) :
  alpha x \in class (position_of d) x -> ~~ odd (lookalikes d).
Proof. by rewrite inE => /crossed_class; rewrite (class_size _ x d). Qed.

(* k = 1: no other world looks like this one.  So it is where v0 has one edge only, and in trees. *)
Theorem one_lookalike_is_unambiguous (G : combinatorial_map) (d : G) :
  [/\ lookalikes d = 1 -> unambiguous d, degree d = 1 -> unambiguous d & acyclic G -> unambiguous d].
Proof. by split; [exact: one_lookalike | exact: one_door | exact: tree_unambiguous]. Qed.

(* The start may be taken for k darts; in the map these are k / a places, a the number of automorphisms
   that keep v0. *)
Theorem places_and_automorphisms (G : combinatorial_map) (d : G) :
  lookalikes d = #|places d| * automorphisms d.
Proof. exact: places_of. Qed.

(* The worlds that look like a given one are its regluings: other ends beta of its darts, where no motions
   tell beta x from alpha x. *)
Theorem lookalike_worlds_are_regluings (G : combinatorial_map) (d : G) :
  let same := indistinct (position_of d) (position_of d) in
  (forall (beta : G -> G) (betaK : involutive beta) (beta_neq : forall x, beta x != x)
     (near : forall x, same (alpha x) (beta x)), look_alike d (d : reglued betaK beta_neq near)) /\
  forall (H : combinatorial_map) (e : H), look_alike d e ->
  exists (beta : G -> G) (betaK : involutive beta) (beta_neq : forall x, beta x != x)
    (near : forall x, same (alpha x) (beta x)),
  isomorphic (rooted (d : reglued betaK beta_neq near)) (rooted e).
Proof. by split=> *; [exact: reglued_alike | exact: alike_reglued]. Qed.

(* So they are finitely many, and can be counted.  The map, v0 in it, can be known if and only if there are
   as many regluings as places times turnings, a turning being a bijection of the darts that turns with
   them, keeps each in its class and fixes the start. *)
Theorem criterion_counted (G : combinatorial_map) (d : G) :
  (forall (H : combinatorial_map) (e : H), look_alike d e ->
     exists2 y : G, at_same_vertex d y & isomorphic (rooted y) (rooted e)) <->
  #|regluings d| = #|places d| * #|[set f | turning d f]|.
Proof. exact: map_known_iff. Qed.

(* The mass formula: both are numbers that the quotient tells.  For each of its ordinary edges there are k!
   ways to reglue what lies over it, for each semi-edge (k-1)(k-3)... ways; and for each of its vertices but
   v0, of cone index b, there are b^(k/b) (k/b)! ways to turn what lies over it. *)
Theorem mass_formula (G : combinatorial_map) (d : G) :
  [/\ #|regluings d| =
        (lookalikes d)`! ^ ordinary_edges d * pairings (lookalikes d) ^ semi_edges d,
      #|[set f | turning d f]| =
        \prod_(B in vertex_classes d | d \notin B) (cone_of d B ^ sheets_of B * (sheets_of B)`!) &
      forall x, cone_of d (vertex_class d x) = cone (position_of d) x /\
        sheets_of (vertex_class d x) * cone (position_of d) x = lookalikes d].
Proof.
split=> [||x]; [exact: regluings_counted | exact: turnings_counted |].
by split; [exact: cone_ofE | exact: sheets_by_cone].
Qed.

Theorem kinds_of_these_worlds :
  [/\ all planar [:: two_loops_plane; k4_plane; hexagon; triangles; figure_1_left; figure_1_right],
      all (predC planar) [:: two_loops_torus; k4_torus]
    & all simple [:: k4_plane; k4_torus; hexagon; triangles; figure_1_left; figure_1_right]].
Proof. exact: kinds. Qed.

Theorem figure_1_caption_holds :
  as_in_the_caption figure_1_left && as_in_the_caption figure_1_right /\
  ~ same_map (denote figure_1_left) (denote figure_1_right).
Proof. exact: conj figure_1_caption figure_1_different. Qed.

(* Any certificate that the Boolean check accepts is such a theorem: for different maps, and for different
   places, in one map or two. *)
Theorem certificate_suffices (P : eqType) (senses : numbered_map -> nat -> P) M N L :
  (map_twin_check senses M N L -> no_explorer_maps_both senses M N) /\
  (twin_check senses M N L -> forall E (meaning : E -> rooted_map) (X : explorer P E),
    ~ (right meaning X (denote M) (senses M) /\ right meaning X (denote N) (senses N))).
Proof. by split; [exact: certified_map_impossible | exact: certified_impossible]. Qed.

(* ==== Folding: the log is a proof of the map (Sections IV, V) ==== *)

(* The log: the motions made and the percepts sensed.  log_dart L: its darts, (i, j) being the j-th dart
   clockwise from the robot's dart after motion i; place W p: the dart of W that p is.  The folding
   identifies log darts (same_dart) and finds other ends (glued) as far as the log forces it to. *)
Theorem folding_is_sound (L : log) (W : lighthouse_world) : agrees W L -> forall p q : log_dart L,
  (same_dart p q -> place W p = place W q) /\
  (glued (@next_dart L) (@crossed L) (@sensed_pointed L) p q -> place W q = alpha (place W p)).
Proof.
by move=> A p q; split; [exact: folding_sound | exact: folding_sound_ends].
Qed.

(* A log that leaves no dart open belongs to one world: marker and way of the robot included. *)
Theorem folded_log_is_the_world (L : log) (W W' : lighthouse_world) :
  agrees W L -> agrees W' L -> no_open_dart L ->
  exists f : W -> W', [/\ bijective f, forall x, f (sigma x) = sigma (f x),
    forall x, f (alpha x) = alpha (f x), f pointed = pointed &
    forall i, i <= size (steps L) -> f (robot_at L W i) = robot_at L W' i].
Proof. exact: folding_determines. Qed.

(* Where a dart is open, two worlds of different size agree with the log. *)
Theorem open_dart_leaves_two_worlds (L : log) (W : lighthouse_world) (p : log_dart L) :
  agrees W L -> ~~ dart_settled p ->
  exists W1 W2, [/\ agrees W1 L, agrees W2 L & edges W1 <> edges W2].
Proof.
move=> A np; have [A1 A2 ne] := open_dart_two_worlds A np.
by do 2 eexists; split; [exact: A1 | exact: A2 |].
Qed.

(* Folding as a program: `labels` gives each dart of the log a number; equal numbers, if and only if the
   darts are the same in the least congruence. *)
Theorem computed_folding (L : log) :
  (forall p q : log_dart L,
     (nth 0 (labels L) (dart_number p) == nth 0 (labels L) (dart_number q)) = same_dart p q) /\
  (folds L <-> no_open_dart L).
Proof. by split; [exact: labels_same | exact: folds_no_open_dart]. Qed.

(* What it folds to, if no dart is open: the world, seen from where the robot is. *)
Theorem computed_folding_is_the_world (L : log) (W : lighthouse_world) : agrees W L -> folds L ->
  valid (folded_map L) /\
  isomorphic (denote (folded_map L)) (rooted (@robot_at L W (size (steps L)))).
Proof. by move=> A /folds_no_open_dart; exact: folded_map_is_the_world. Qed.

(* So whoever stops where a dart is open is lucky: it does not find the maps of all worlds. *)
Theorem open_log_refutes u E (meaning : E -> rooted_map) (X : explorer percept E)
    (W : lighthouse_world) : in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  ~~ folds (log_of W t) -> ~ finds_all_maps u meaning X.
Proof. exact: unfolded_refutes. Qed.

(* ==== The shield ==== *)

(* Any explorer X, whatever it does, and Algorithm 1 take turns; the answer is the folded map.  It is
   right in every world, within nine times (1) + (2); and within nine times the motions of X, as soon as
   the log of these leaves no dart open. *)
Theorem shield_is_right E (X : explorer percept E) (pol : policy) (W : lighthouse_world) :
  right_within (as_explorer (shield X (algorithm1 pol))) (M := rooted (@start W)) (@percept_of W)
    (9 * paper_bound (vertices W) (edges W)) /\
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, e, z) ->
  folds (log_of W t) ->
  right_within (as_explorer (shield X (algorithm1 pol))) (M := rooted (@start W)) (@percept_of W)
    (9 * size t).
Proof.
split=> [|b t e z R /folds_no_open_dart]; [exact: shield_correct | exact: shield_of_folder R].
Qed.

(* ==== Lower bounds (Section VI) ==== *)

(* Explorers that find the map of all worlds, or of all simple worlds.  They exist: *)
Theorem algorithm1_finds_every_map pol u : finds_all_maps u denote (algorithm1 pol).
Proof. exact: algorithm1_finds_all_maps. Qed.

(* At least m motions in each world. *)
Theorem at_least_m_motions u E (meaning : E -> rooted_map) (X : explorer percept E) :
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) -> edges W <= size t.
Proof. by move=> F W U budget t e z; exact: (edges_at_most_motions F). Qed.

(* At least m-n+1 entries into v0. *)
Theorem entries_lower_bound u E (meaning : E -> rooted_map) (X : explorer percept E) :
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W + 1 <= vertices W + entries (unzip1 t) (@start W).
Proof. by move=> F W U budget t e z; exact: (entries_at_least F). Qed.

(* Any world W at the end of a path of L edges, v0 at the other end: at least 2 L (m-n+1) motions. *)
Theorem path_lower_bound u E (meaning : E -> rooted_map) (X : explorer percept E) :
  finds_all_maps u meaning X -> forall W L budget t e z, in_universe u W ->
  let W' := at_end_of_path L W in
  episode X (rooted (@start W')) (@percept_of W') budget = (t, Some e, z) ->
  2 * L * (edges W + 1 - vertices W) <= size t.
Proof. exact: path_costs_every_cycle. Qed.

(* ==== Enumeration ==== *)

(* rooted_maps m lists the connected rooted maps with m edges, each once. *)
Theorem enumeration_is_sound m M : M \in rooted_maps m ->
  [/\ valid M, connected (denote M) & size (sigma_list M) = m.*2].
Proof. exact: rooted_maps_sound. Qed.

Theorem enumeration_is_complete (G : combinatorial_map) (d : G) :
  exists2 M, M \in rooted_maps (edges G) & isomorphic (rooted d) (denote M).
Proof. exact: rooted_maps_complete. Qed.

Theorem enumeration_has_no_repeats m : uniq (rooted_maps m) /\
  forall M N, M \in rooted_maps m -> N \in rooted_maps m -> isomorphic (denote M) (denote N) -> M = N.
Proof. exact: conj (rooted_maps_uniq m) (@rooted_maps_distinct m). Qed.

Set Warnings "-abstract-large-number".
Theorem enumeration_counts : [seq size (rooted_maps m) | m <- iota 1 5] = [:: 2; 10; 74; 706; 8162].
Proof. exact: counts. Qed.

(* ==== The checker (checker_is_right in Main.v) ==== *)

(* Any explorer can be asked about. *)
Theorem every_explorer_can_be_checked O (X : explorer O numbered_map) o seen :
  as_explorer (remembering X) (o :: seen) = X (o :: seen).
Proof. exact: as_remembering. Qed.

(* Every world that it lists as a refutation is one. *)
Theorem refutations_are_right S (r : resumption S percept) limit u m M k :
  (M, k) \in directional_refutations r limit u m ->
  exists (V : valid M) (C : connected (denote M)), let W := world_of_numbers V C k in
  [/\ in_universe u W, edges W = m &
      ~ right_within (as_explorer r) (M := rooted (@start W)) (@percept_of W)
          (limit (vertices W) (edges W) (degree (@start W)))].
Proof. exact: directional_refutation. Qed.

(* The same with the cluster of undirected markers, and with the natural lighthouse. *)
Theorem checkers_of_other_lighthouses S (r : resumption S (nat * nat)) limit m :
  (cluster_check r limit m <-> forall W : lighthouse_world, one_edge W -> edges W <= m ->
     right_within (as_explorer r) (M := rooted (@start W)) (@cluster_percept W)
       (limit (vertices W) (edges W) (degree (@start W)))) /\
  (natural_check r limit m <-> forall W : lighthouse_world, natural_kind W -> edges W <= m ->
     right_within (as_explorer r) (M := rooted (@start W)) (@natural_percept W)
       (limit (vertices W) (edges W) (degree (@start W)))).
Proof. by split; [exact: cluster_check_correct | exact: natural_check_correct]. Qed.

(* Algorithm 1 passes, under every policy and however far one looks. *)
Theorem algorithm1_passes pol u m :
  [/\ directional_check (algorithm1_resumption pol) (fun n m _ => paper_limit n m) u m,
      cluster_check (cluster_resumption pol) two_vertices_limit m
    & natural_check (natural_resumption pol) two_vertices_limit m].
Proof. by split; [exact: algorithm1_checked|exact: cluster_checked|exact: natural_checked]. Qed.

(* ==== Certificates (certificate_is_right in Main.v) ==== *)

(* What the file of a certificate states, the limit being (1) + (2): episode gives the explorer so many
   motions at most. *)
Theorem certificate_within_paper_bound (tree : branches) m : certified tree paper AllWorlds m ->
  forall X, answers_as X tree -> forall W : lighthouse_world, edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (paper_bound (vertices W) (edges W))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. exact: certified_paper. Qed.

(* None is missing: an explorer, any function of the percepts, has a certificate if and only if it is right in
   these worlds. *)
Theorem right_explorers_have_certificates X limit u m :
  (forall W : lighthouse_world, in_universe u W -> edges W <= m ->
   right_within X (M := rooted (@start W)) (@percept_of W)
     (limit (vertices W) (edges W) (degree (@start W)))) <->
  exists2 tree, answers_as X tree & certified tree limit u m.
Proof. exact: certificate_exists. Qed.

(* It speaks of something: every tree is answered as by some explorer. *)
Theorem trees_are_answered (tree : branches) : exists X, answers_as X tree.
Proof. exact: tree_answered. Qed.

(* ==== Lighthouses without a direction (Sections IV and VIII) ==== *)

(* The marker cluster of Main.v, for every schedule: a run can be finished, and a finished run has made m
   passes. *)
Theorem cluster_right_for_every_schedule (W : lighthouse_world) : one_edge W ->
  let reached := reached_by coarse (leads_to_v1 (@cluster_percept W) (has_markers 2)) 2 in
  forall q C c, reached q C c ->
  (exists C' c', reached (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= cluster_bound W & robot_knows c]).
Proof. by move=> H reached q C c; exact: cluster_runs. Qed.

(* The robot lays the cluster itself: three markers are in its hand (Carrying.v).  It
   drops one at v0, tries its darts in turn until one is no loop, drops two behind it, comes back, and
   runs Algorithm 1.  W: the world with `pointed` the first dart that is no loop.  Cost: two traversals
   for each dart tried, and as before; three drops. *)
Theorem cluster_can_be_laid (W : lighthouse_world) : loops_before W -> one_edge W -> forall pol budget,
  2 * degree (@start W) + cluster_bound W + 3 <= budget -> exists t answer z,
  [/\ carrying_episode 3 (laying_algorithm pol) (@start W) budget
        = (t, Some answer, (z, [:: alpha (@pointed W); alpha (@pointed W); @start W])),
      traversals t <= 2 * degree (@start W) + cluster_bound W, size t = traversals t + 3,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> l o pol budget; exact: laying_correct. Qed.

(* In every simple world, from every dart, the hypotheses hold. *)
Theorem cluster_can_be_laid_in_simple_worlds (G : combinatorial_map) (d : G) : simple_world G ->
  let W := @LighthouseWorld G d d (connect0 _ d) in loops_before W /\ one_edge W.
Proof. exact: simple_loops_before. Qed.

(* One marker that can be picked up again, of Dudek, Jenkin, Milios and Wilkes 1991, in every world with
   at most one edge between two vertices and one loop at each.  Moves, drops and picks are counted; in the
   end the marker is in the hand. *)
Theorem movable_marker_is_right (G : combinatorial_map) (d : G) : one_edge_each G -> forall pol budget,
  edges G * (5 * vertices G + 2 * \max_(x : G) degree x) <= budget -> exists t answer z,
  [/\ carrying_episode 1 (movable pol) d budget = (t, Some answer, (z, [::])),
      size t <= edges G * (5 * vertices G + 2 * \max_(x : G) degree x),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> one pol budget; exact: movable_correct. Qed.

(* With several loops no number of markers is enough: in all worlds with one vertex of one degree a robot
   does and senses the same. *)
Theorem markers_do_not_tell_loops (G H : combinatorial_map) (d : G) (e : H) :
  (forall x y : G, at_same_vertex x y) -> (forall x y : H, at_same_vertex x y) -> degree d = degree e ->
  forall hand A (X : carrying_explorer A) budget,
  (carrying_episode hand X d budget).1 = (carrying_episode hand X e budget).1.
Proof. by move=> oG oH E hand A X budget; exact: one_vertex_alike. Qed.

(* With two edges between v0 and v1 a cluster is not enough. *)
Theorem cluster_needs_one_edge :
  (edges_to_v1 natural_plane = 2 /\ edges_to_v1 natural_torus = 2) /\
  no_explorer_maps_both cluster_percept_in natural_plane natural_torus.
Proof. exact: conj two_edges_between two_edges_impossible. Qed.

(* In a simple world no two edges join v0 and v1. *)
Theorem simple_worlds_have_one_edge (W : lighthouse_world) : simple_world W -> one_edge W.
Proof. exact: simple_one_edge. Qed.

(* A natural lighthouse, degrees only: v0 and v1 have degrees that no other vertex has, and the robot is
   told that of v1. *)
Theorem natural_lighthouse_is_right (W : lighthouse_world) :
  unique (@start W) -> unique (alpha (@pointed W)) -> one_edge W -> forall (pol : policy) budget,
  2 * degree (@start W) + cluster_bound W <= budget -> exists transcript answer z,
  [/\ episode (natural_algorithm (degree (alpha (@pointed W))) pol) (rooted (@start W)) (@degree W)
        budget = (transcript, Some answer, z),
      size transcript <= 2 * degree (@start W) + cluster_bound W,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> u0 u1 H pol budget; exact: natural_correct. Qed.

(* With two edges between them that is not enough: v0 has darts 0 and 1, v1 the six others. *)
Theorem natural_lighthouse_is_not_enough :
  [/\ all (fun M => map (degree_at M) (iota 0 8) == [:: 2; 2; 6; 6; 6; 6; 6; 6])
          [:: natural_plane; natural_torus],
      edges_to_v1 natural_plane = 2 /\ edges_to_v1 natural_torus = 2
    & no_explorer_maps_both degree_percept natural_plane natural_torus].
Proof. exact: And3 natural_degrees two_edges_between natural_impossible. Qed.

(* Worlds with such lighthouses exist. *)
Theorem kinds_of_lighthouse_exist : (forall W, one_edge (longer W)) /\
  forall k, [/\ unique (@start (longer (bouquet k))), unique (alpha (@pointed (longer (bouquet k))))
              & one_edge (longer (bouquet k))].
Proof. exact: conj cluster_hypotheses_met natural_hypotheses_met. Qed.

(* ==== Sensors (the first theorems on them are in Main.v) ==== *)

(* If, for one degree: two indistinguishable worlds are isomorphic with their starts, and the door is where it
   was, as many darts from the start. *)
Theorem primitive_words_leave_no_twins w (W W' : lighthouse_world) :
  primitive (word w (degree (@start W))) -> ~~ blank (word w (degree (@start W))) ->
  indistinguishable (at_v0 w) W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W')) /\ first_bearing W = first_bearing W'.
Proof. by move=> P B; exact: adequate_suffices. Qed.

(* Only if, for one degree: two worlds that are indistinguishable, and different maps wherever the start is;
   no explorer finds both. *)
Theorem other_words_leave_twins w d : 0 < d -> proper_power (word w d) \/ blank (word w d) ->
  exists W W' : lighthouse_world,
  [/\ degree (@start W) = d, indistinguishable (at_v0 w) W W',
      ~ same_map (rooted (@start W)) (rooted (@start W'))
    & no_explorer_finds_both (M := rooted (@start W)) (N := rooted (@start W'))
        (percept_by (at_v0 w) (W := W)) (percept_by (at_v0 w) (W := W'))].
Proof. exact: inadequate_twins. Qed.

(* Both, for one degree: sufficient_at lambda d is sufficient lambda for worlds in which v0 has degree d. *)
Theorem each_degree_by_itself w d : 0 < d ->
  sufficient_at (at_v0 w) d <-> primitive (word w d) /\ ~~ blank (word w d).
Proof. exact: degree_iff. Qed.

(* The tool for 'if', which serves for other sensors too: a world is rigid if no two of its darts look alike. *)
Theorem rigid_worlds_have_no_twins (A : eqType) (lambda : sensor A) (W W' : lighthouse_world) :
  rigid lambda W -> rigid lambda W' -> indistinguishable lambda W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W')).
Proof. exact: rigid_isomorphic. Qed.

(* How large they are: d + k edges each if the word is u^k, 2 and 4 if the word for degree 1 is blank. *)
Theorem sizes_of_these_twins w :
  (forall d k v, 0 < d -> 1 < k -> word w d = flatten (nseq k v) -> exists W W' : lighthouse_world,
   [/\ degree (@start W) = d, edges W = d + k, edges W' = d + k,
       indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))]) /\
  (blank (word w 1) -> exists W W' : lighthouse_world,
   [/\ degree (@start W) = 1, edges W = 2, edges W' = 4,
       indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))]).
Proof. by split=> [d k v|]; [exact: SensorTwins.power_twins | exact: SensorTwins.blank_twins]. Qed.

(* An isomorphism changes no letter of a sensor at v0; the letter is a function of the degree and the bearing
   of Model.v. *)
Theorem letters_are_invariant w : invariant (at_v0 w) /\ forall (W : lighthouse_world) (d : W),
  at_v0 w pointed d = if bearing d is Some b then w (degree d) b else 0.
Proof. exact: conj (at_v0_invariant w) (@letter_of_bearing w). Qed.

(* The directional lighthouse is sufficient, and the door is strictly coarser; the position is not sufficient;
   what is finer than a sufficient sensor is sufficient. *)
Theorem order_of_sensors :
  [/\ sufficient (at_v0 directional_word), strictly_coarser (at_v0 door_word) (at_v0 directional_word),
      ~ sufficient (at_v0 position_word) &
      forall A B (lambda : sensor A) (mu : sensor B),
      coarser lambda mu -> sufficient lambda -> sufficient mu].
Proof.
exact: And4 directional_suffices door_strictly_coarser position_fails (@sufficient_finer).
Qed.

(* In which half the door is is enough, and so is how far it is, the side not told.  The bearing modulo q is
   enough at degree d unless q divides d and is less: parity (q = 2) fails first at degree 4, and is enough
   at all odd degrees. *)
Theorem other_sensors_at_v0 :
  [/\ sufficient (at_v0 half_word), sufficient (at_v0 distance_word) &
      forall q d, 0 < q -> 0 < d ->
      sufficient_at (at_v0 (remainder_word q)) d <-> ~~ ((q %| d) && (q < d))].
Proof. exact: And3 half_suffices distance_suffices remainder_suffices. Qed.

(* Sensors that look further than v0.  feature r x is one of six kinds of darts, by their place relative to the
   door r; coarsened c shows the letter c i for kind i (Features.v).  Such a sensor is sufficient if and only if one
   of three conditions on its letters holds: the dart behind the door shows its letter alone; or the door's
   letter is at v0 alone, that of the dart behind it neither there nor at neighbours; or none of ten sets of
   features share letters. *)
Theorem features_that_suffice c : invariant (coarsened c) /\
  (sufficient (coarsened c) <-> [|| reason_behind c, reason_edge c | reason_apart c]).
Proof. exact: conj (coarsened_invariant c) (suffices_iff c). Qed.

(* The six features have 203 coarsenings, each listed once; 131 are sufficient, in worlds of all sizes; of 24 of
   these nothing that tells less is. *)
Theorem weakest_sensors :
  [/\ [/\ uniq coarsenings, forall c, exists2 u, u \in coarsenings & same_letters c (nth 0 u) &
        forall u v, u \in coarsenings -> v \in coarsenings -> same_letters (nth 0 u) (nth 0 v) -> u = v],
      [/\ size coarsenings = 203, size sufficing = 131 & size weakest = 24],
      forall u, u \in coarsenings -> u \in sufficing <-> sufficient (coarsened (nth 0 u)) &
      forall u, u \in coarsenings -> u \in weakest <-> sufficient (coarsened (nth 0 u)) /\
      forall c, tells_less (nth 0 u) c -> sufficient (coarsened c) -> tells_less c (nth 0 u)].
Proof. exact: And4 each_once rows_counted sufficing_iff weakest_iff. Qed.

(* An explorer for each of them: at the end of each test, and once at the start, the robot scans the vertex
   where it is, out and back by each dart, and compares the letters.  Only the word for the degree of v0
   matters. *)
Theorem scanning_is_right w (W : lighthouse_world) : let d := degree (@start W) in
  primitive (word w d) -> ~~ blank (word w d) -> forall (pol : policy) budget,
  let bound := 2 * d + (paper_bound (vertices W) (edges W) + 2 * d * edges W ^ 2) in
  bound <= budget -> exists transcript answer z,
  [/\ episode (scanning_algorithm w pol) (rooted (@start W)) (percept_by (at_v0 w) (W := W)) budget
        = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> d P B pol budget; exact: scanning_correct. Qed.

(* So for sensors at v0 to suffice is to be enough for one explorer, without any bound on the worlds. *)
Theorem one_explorer_for_all_worlds w : sufficient (at_v0 w) <->
  exists X : explorer (nat * nat) numbered_map, forall W : lighthouse_world,
  right denote X (rooted (@start W)) (percept_by (at_v0 w) (W := W)).
Proof. exact: sufficient_iff_explored. Qed.

(* The explorer for the door, for every schedule: a run can be finished, and a finished run has made m
   passes. *)
Theorem door_right_for_every_schedule (W : lighthouse_world) :
  let reached := reached_by seen_of (@rung W) 2 in
  forall q C c, reached q C c ->
  (exists C' c', reached (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= door_bound W & robot_knows c]).
Proof. by move=> reached q C c; exact: door_runs. Qed.

(* What the search for the door and the tests cost: the search at most 2 (deg(v0) - 1) traversals; the rest 2m
   less than (1) + (2) with n_s in place of n_s - 1, and n in place of n - 1, in the second factors. *)
Theorem cost_of_the_door (W : lighthouse_world) : let n := vertices W in let m := edges W in
  first_bearing W < degree (@start W) /\
  door_bound W + 2 * m = \sum_(1 <= s < n) (s + 2 * s * (2 * m - 2 * (s - 1))) +
    \sum_(1 <= i < (m - (n - 1)).+1) (n + 2 * n * (2 * m - 2 * (n - 1) - 2 * (i - 1))).
Proof. exact: conj (first_bearing_lt W) (door_bound_sum W). Qed.

(* ==== The robot elsewhere (Sections I, II.B and VIII) ==== *)

(* A robot that starts at any dart x of the world, and does not know where v0 is: it tries all words of motions,
   shorter ones first, and takes each back.  In every world, from every start, it comes to v0, after some log t,
   and from there on does what the explorer X does there. *)
Theorem marker_is_found_from_everywhere (W : lighthouse_world) (x : W) E (X : explorer percept E) :
  exists t z, at_same_vertex (start : W) z /\ forall budget,
  episode (elsewhere X) (rooted x) (@percept_of W) (size t + budget) =
    let: (t', e, z') := episode X (rooted z) (@percept_of W) budget in (t ++ t', e, z').
Proof. exact: elsewhere_finds. Qed.

(* So who is right from v0 is right from everywhere: the map is the world's, and the place in it the robot's. *)
Theorem right_from_everywhere E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W)) ->
  forall (W : lighthouse_world) (x : W), right meaning (elsewhere X) (rooted x) (@percept_of W).
Proof. exact: elsewhere_right. Qed.

(* The cost for Algorithm 1, where a word of at most L motions leads to v0, and no degree is above D: (1) + (2),
   and for the search less than 8 D^L, if D is not 1. *)
Theorem cost_from_elsewhere (W : lighthouse_world) (pol : policy) D L (x : W) budget :
  (forall d : W, degree d <= D) -> (exists2 w, size w <= L & at_same_vertex start (walk w x)) ->
  let bound := search_cost D L + paper_bound (vertices W) (edges W) in
  (bound <= budget -> exists transcript answer z,
   [/\ episode (elsewhere (algorithm1 pol)) (rooted x) (@percept_of W) budget = (transcript, Some answer, z),
       size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)]) /\
  (1 < D -> search_cost D L + 8 <= 8 * D ^ L).
Proof. by move=> le near bound; split; [exact: elsewhere_algorithm1 | exact: search_cost_le]. Qed.

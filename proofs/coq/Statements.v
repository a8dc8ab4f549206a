(* ---------------------------------------------------------------------------------------------
   The statements of the headline theorems, once more: this file compiles only if each theorem of Main.v
   and of Further.v has the statement that is written here, so none can be replaced by a weaker one unseen.

   Each part requires what its file requires: a name may mean something else in the other.

   check_assumptions.py sees that each theorem has its Check. What a definition means is not said here:
   mutants/ has wrong ones, which break a proof or a statement.
   --------------------------------------------------------------------------------------------- *)
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Set Warnings "-abstract-large-number".

(* ==== Main.v ==== *)

From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Pass Cost.
From Allworlds Require Import Correctness Algorithm Refinement Impossibility Twins Log OpenDarts.
From Allworlds Require Import LowerBounds Cluster Checker DecisionTrees Words Sensors OneBit Door Mapping.
From Allworlds Require Import Main.

Check (@no_information_is_not_enough :
  forall n n' side, 0 < n -> 0 < n' -> n <> n' ->
  no_explorer_finds_both (M := cycle_world n side) (N := cycle_world n' side)
    (fun _ => 2) (fun _ => 2)).

Check (@orientation_is_not_enough :
  forall n n' side, 0 < n -> 0 < n' -> n <> n' ->
  no_explorer_finds_both (M := cycle_world n side) (N := cycle_world n' side)
    (fun d => (2, d.2)) (fun d => (2, d.2))).

Check (@position_is_not_enough :
  [/\ no_explorer_maps_both position_percept two_loops_plane two_loops_torus,
      no_explorer_maps_both position_percept k4_plane k4_torus,
      no_explorer_maps_both position_percept hexagon triangles &
      no_explorer_maps_both position_percept figure_1_left figure_1_right]).

Check (@explorer_correct :
  forall (pol : policy) (W : lighthouse_world) budget,
  paper_bound (vertices W) (edges W) <= budget -> exists transcript answer z,
  [/\ episode (algorithm1 pol) (rooted start) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= paper_bound (vertices W) (edges W),
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@invariant_holds :
  forall (W : lighthouse_world) n C (c : configuration W), reached n C c ->
  exists r, [/\ I1 start (mapped c) r, I2 start (mapped c) r,
                known (mapped c) (here c) & robot c = phi start r (here c)]).

Check (@correct_when_done :
  forall (W : lighthouse_world) n C (c : configuration W), reached n C c ->
  (forall e, ~~ is_open (mapped c) e) ->
  [/\ n = edges W, C <= paper_bound (vertices W) (edges W) &
      isomorphic (map_with_robot (mapped c) (here c)) (rooted (robot c))]).

Check (@runs_end :
  forall (W : lighthouse_world) n C (c : configuration W),
  reached n C c ->
  n <= edges W /\ exists C' (c' : configuration W),
    [/\ reached (edges W) C' c', forall e, ~~ is_open (mapped c') e & C <= C']).

Check (@cost_is_O_m2n :
  forall (W : lighthouse_world) n C (c : configuration W),
  reached n C c -> C <= 2 * edges W ^ 2 * vertices W).

Check (@checker_is_right :
  forall S (r : resumption S percept) limit u m, directional_check r limit u m <->
  forall W : lighthouse_world, in_universe u W -> edges W <= m ->
  right_within (as_explorer r) (M := rooted (@start W)) (@percept_of W)
    (limit (vertices W) (edges W) (degree (@start W)))).

Check (@certificate_is_right :
  forall (tree : branches) limit u m, certified tree limit u m <->
  forall X : explorer percept numbered_map, answers_as X tree ->
  forall W : lighthouse_world, in_universe u W -> edges W <= m ->
  right_within X (M := rooted (@start W)) (@percept_of W)
    (limit (vertices W) (edges W) (degree (@start W)))).

Check (@log_of_a_right_explorer_folds :
  forall u E (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) -> no_open_dart (log_of W t)).

Check (@quadratic_lower_bound :
  forall k,
  exists W : lighthouse_world,
  [/\ edges W = k.+1.*2, vertices W = k.+2 &
  forall E (meaning : E -> rooted_map) (X : explorer percept E), finds_all_maps AllWorlds meaning X ->
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W * (vertices W - 1) <= size t]).

Check (@quadratic_lower_bound_in_simple_worlds :
  forall q,
  7 <= q -> exists W : lighthouse_world,
  [/\ simple_world W, edges W = 'C(q.+1, 2), vertices W = q.*2 &
  forall E (meaning : E -> rooted_map) (X : explorer percept E), finds_all_maps SimpleWorlds meaning X ->
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W * vertices W <= 2 * size t]).

Check (@cluster_is_right :
  forall (W : lighthouse_world),
  one_edge W -> forall (pol : policy) budget,
  2 * degree (@start W) + cluster_bound W <= budget -> exists transcript answer z,
  [/\ episode (cluster_algorithm pol) (rooted (@start W)) (@cluster_percept W) budget
        = (transcript, Some answer, z),
      size transcript <= 2 * degree (@start W) + cluster_bound W,
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@to_suffice_is_to_be_enough :
  forall (A : eqType) (lambda : sensor A),
  invariant lambda ->
  sufficient lambda <-> forall m, exists X : explorer (nat * A) numbered_map,
  forall W : lighthouse_world, edges W <= m ->
  right denote X (rooted (@start W)) (percept_by lambda (W := W))).

Check (@sensors_that_suffice :
  forall w,
  sufficient (at_v0 w) <->
  forall d, 0 < d -> primitive (word w d) /\ ~~ blank (word w d)).

Check (@one_bit_is_enough :
  [/\ sufficient (at_v0 door_word), minimal (at_v0 door_word) & ~ minimal (at_v0 directional_word)]).

Check (@door_is_right :
  forall (pol : policy) (W : lighthouse_world) budget,
  2 * first_bearing W + door_bound W <= budget -> exists transcript answer z,
  [/\ episode (door_algorithm pol) (rooted (@start W)) (percept_by (at_v0 door_word) (W := W)) budget
        = (transcript, Some answer, z),
      size transcript <= 2 * first_bearing W + door_bound W,
      valid answer & isomorphic (denote answer) (rooted z)]).

(* ==== Further.v ==== *)

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
From Allworlds Require Import Further.

Check (@motion_is_reversible :
  forall (G : combinatorial_map) (w : seq nat),
  (forall d : G, exists v j, size v = size w /\ iter j sigma (walk v (walk w d)) = d) /\
  injective (@walk G w)).

Check (@tests_decide :
  forall (W : lighthouse_world) n C (c : configuration W), reached n C c ->
  exists2 r, I1 start (mapped c) r & forall w h f,
    known (mapped c) h -> follow (mapped c) w h = Some f -> f.1 = 0 ->
    (forall x : W, percepts_along w x = expected_percepts (first_bearing W) (mapped c) w h
                   <-> x = phi start r h) /\
    (forall h' f', known (mapped c) h' -> follow (mapped c) w h' = Some f' ->
       expected_percepts (first_bearing W) (mapped c) w h
       = expected_percepts (first_bearing W) (mapped c) w h' -> h = h')).

Check (@never_stuck :
  forall (W : lighthouse_world) n C (c : configuration W) e, reached n C c ->
  is_open (mapped c) e -> exists C' c', pass e c C' c').

Check (@variant_falls :
  forall (W : lighthouse_world) n C (c : configuration W) e C' c', reached n C c ->
  pass e c C' c' -> variant c = (variant c').+1).

Check (@explorer_right :
  forall (W : lighthouse_world) (pol : policy),
  right denote (algorithm1 pol) (rooted start) (@percept_of W)).

Check (@paths_are_shortest :
  forall S a w f, known S a ->
  (forall x y, partner S x = Some y -> known S y) ->
  follow S w a = Some f -> let way := route S a f.1 in
  [/\ follow S way.1 a = Some way.2, way.2.1 = f.1 & size way.1 <= size w]).

Check (@nearest_takes_the_nearest :
  forall k, unexplored k != [::] ->
  next_edge nearest k \in unexplored k /\
  forall e, e \in unexplored k -> distance k (next_edge nearest k) <= distance k e).

Check (@explorer_correct_in_numbers :
  forall (pol : policy) (M : numbered_map) k budget,
  valid M -> size (dart_order M) == size (sigma_list M) ->
  let limit := paper_limit (vertices_in M) (edges_in M) in limit <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (denote M) (directional_senses M k) budget
        = (transcript, Some answer, z),
      size transcript <= limit & same_code answer (seen_from M z)]).

Check (@machine_is_explorer :
  forall O B (L : lighthouse O B) (pol : policy) (M : rooted_map)
    (senses : carrier M -> O) budget,
  episode (explorer_by L pol) M senses budget
  = machine L pol (motion_in M) senses budget (set_out L (senses (root M))) (root M)).

Check (@program_is_an_instance :
  forall (W : lighthouse_world) (pol : policy) k c d, sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes (@percept_of W) (one_pass directional pol k) d k' z n,
    pass (next_edge pol k) c n c' & knows k' c' z]).

Check (@bound_is_polynomial :
  forall n m, 0 < n -> n - 1 <= m ->
  6 * paper_bound n m + 12 * m * n ^ 2 + 12 * m ^ 2 + 15 * n ^ 2 + 12 * m
  = 12 * m ^ 2 * n + 4 * n ^ 3 + 30 * m * n + 11 * n).

Check (@passes_of_both_kinds :
  forall (W : lighthouse_world) (c : configuration W),
  (forall n C, reached n C c <-> exists v l, counted v l C c /\ v + l = n) /\
  forall v l C, counted v l C c -> nothing_open c ->
  v.+1 = vertices W /\ l + vertices W = (edges W).+1).

Check (@m_is_enough_on_cycles :
  forall k b, let W := ring k b in
  edges W = k.+1 /\ vertices W = k.+1 /\ forall budget, edges W <= budget -> exists t answer z,
  [/\ episode (algorithm1 lifo) (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z),
      size t = edges W, valid answer & isomorphic (denote answer) (rooted z)]).

Check (@same_map_decided :
  forall M N, valid M -> valid N -> connected (denote M) ->
  reflect (isomorphic (denote M) (denote N)) (same_code M N)).

Check (@judge_correct :
  forall M e z,
  valid M -> connected (denote M) -> z < size (sigma_list M) ->
  size (alpha_list e) = size (sigma_list e) ->
  [/\ judge M z e = IsRight <-> is_world_from M e z,
      judge M z e = WrongPose <->
        ~ is_world_from M e z /\ exists2 d, d < size (sigma_list M) & is_world_from M e d
    & judge M z e = WrongMap <-> forall d, d < size (sigma_list M) -> ~ is_world_from M e d]).

Check (@cycles_are_worlds :
  forall n side, 0 < n ->
  [/\ wellformed (cycle_world n side), connected (cycle_world n side) &
      forall d, sigma_of (cycle_world n side) (sigma_of (cycle_world n side) d) = d /\
                sigma_of (cycle_world n side) d <> d]).

Check (@twins_cannot_both_be_explored :
  forall P E (meaning : E -> rooted_map) (X : explorer P E)
    (M N : rooted_map) (sensesM : carrier M -> P) (sensesN : carrier N -> P)
    (R : carrier M -> carrier N -> Prop),
  (forall x y, R x y -> sensesM x = sensesN y) ->
  (forall x y, R x y -> R (sigma_of M x) (sigma_of N y)) ->
  (forall x y, R x y -> R (alpha_of M x) (alpha_of N y)) ->
  R (root M) (root N) -> wellformed M -> wellformed N ->
  (right meaning X M sensesM -> right meaning X N sensesN -> isomorphic M N) /\
  (finds_map meaning X M sensesM -> finds_map meaning X N sensesN -> same_map M N)).

Check (@being_right_is_more :
  forall P E (meaning : E -> rooted_map) (X : explorer P E) M (obs : carrier M -> P),
  right meaning X M obs -> finds_map meaning X M obs).

Check (@randomness_does_not_help :
  forall P (M N : rooted_map) (sM : carrier M -> P) (sN : carrier N -> P)
    E (meaning : E -> rooted_map) (Seed : finType) (weight : Seed -> nat) (X : Seed -> explorer P E)
    (A B : {set Seed}),
  no_explorer_finds_both sM sN ->
  (forall s, s \in A -> finds_map meaning (X s) M sM) ->
  (forall s, s \in B -> finds_map meaning (X s) N sN) ->
  \sum_(s in A) weight s + \sum_(s in B) weight s <= \sum_s weight s).

Check (@lighthouse_leaves_no_twins :
  forall (W W' : lighthouse_world) (R : W -> W' -> Prop),
  (forall x y, R x y -> percept_of x = percept_of y) ->
  (forall x y, R x y -> R (sigma x) (sigma y)) -> (forall x y, R x y -> R (alpha x) (alpha y)) ->
  R start start -> isomorphic (rooted (@start W)) (rooted (@start W'))).

Check (@no_world_with_a_cycle_without_position :
  forall (G : combinatorial_map) (e : G) (cycle : on_cycle e)
    (d : G) (ref : pred G),
  let H := double_cover cycle in
  [/\ no_explorer_finds_both (M := rooted d) (N := rooted ((d, false) : H))
        (@degree_sensed G) (@degree_sensed H),
      no_explorer_finds_both (M := rooted d) (N := rooted ((d, false) : H))
        (compass ref) (@compass H (fun p => ref p.1))
    & simple_world G -> simple_world H]).

Check (@trees_without_position :
  forall pol (G : combinatorial_map) (d : G), acyclic G ->
  right denote (without_position (algorithm1 pol)) (rooted d) (@degree_sensed G)).

Check (@only_trees_without_position :
  forall (G : combinatorial_map) (d : G), (forall e : G, ~~ on_cycle e) <->
  forall (H : combinatorial_map) (d' : H),
  (forall w, percepts_in (M := rooted d) (@degree G) w d
           = percepts_in (M := rooted d') (@degree H) w d') ->
  isomorphic (rooted d) (rooted d')).

Check (@cycles_with_position :
  forall n side, 0 < n ->
  right (fun n => cycle_world n true) round_once (cycle_world n side) position_on_cycle).

Check (@lookalikes_have_one_size :
  forall (G H : combinatorial_map) (d : G) (e : H), look_alike d e ->
  [/\ edges G = edges H, vertices G = vertices H, degree d = degree e &
      forall k, #|[pred x : G | degree x == k]| = #|[pred y : H | degree y == k]|]).

Check (@no_smaller_pairs :
  forall (G H : combinatorial_map) (d : G) (e : H),
  look_alike d e ->
  [/\ edges G <= 1 -> isomorphic (rooted d) (rooted e),
      simple_world G -> simple_world H -> edges G <= 5 -> isomorphic (rooted d) (rooted e) &
      simple_world G -> simple_world H -> planar_map G -> planar_map H -> edges G <= 7 ->
      exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e')]).

Check (@one_walk_tells_small_worlds_apart :
  forall (G H : combinatorial_map) (d : G) (e : H), simple_world G -> simple_world H ->
  (edges G <= 5 -> edges H <= 5 -> walk_alike d e simple_walk -> isomorphic (rooted d) (rooted e)) /\
  (planar_map G -> planar_map H -> edges G <= 7 -> edges H <= 7 -> walk_alike d e planar_walk ->
   exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e'))).

Check (@classes_of_lookalikes :
  forall (G : combinatorial_map) (d x : G), let senses := position_of d in
  [/\ #|class senses x| = lookalikes d, #|G| = #|classes senses| * lookalikes d,
      lookalikes d %| degree d, cone senses x %| degree x
    & lookalikes d = #|class_vertices senses x| * cone senses x]).

Check (@crossed_classes_are_even :
  forall (G : combinatorial_map) (d x : G), alpha x \in class (position_of d) x -> ~~ odd (lookalikes d)).

Check (@one_lookalike_is_unambiguous :
  forall (G : combinatorial_map) (d : G),
  [/\ lookalikes d = 1 -> unambiguous d, degree d = 1 -> unambiguous d & acyclic G -> unambiguous d]).

Check (@places_and_automorphisms :
  forall (G : combinatorial_map) (d : G), lookalikes d = #|places d| * automorphisms d).

Check (@lookalike_worlds_are_regluings :
  forall (G : combinatorial_map) (d : G), let same := indistinct (position_of d) (position_of d) in
  (forall (beta : G -> G) (betaK : involutive beta) (beta_neq : forall x, beta x != x)
     (near : forall x, same (alpha x) (beta x)), look_alike d (d : reglued betaK beta_neq near)) /\
  forall (H : combinatorial_map) (e : H), look_alike d e ->
  exists (beta : G -> G) (betaK : involutive beta) (beta_neq : forall x, beta x != x)
    (near : forall x, same (alpha x) (beta x)),
  isomorphic (rooted (d : reglued betaK beta_neq near)) (rooted e)).

Check (@criterion_counted :
  forall (G : combinatorial_map) (d : G), (forall (H : combinatorial_map) (e : H), look_alike d e ->
     exists2 y : G, at_same_vertex d y & isomorphic (rooted y) (rooted e)) <->
  #|regluings d| = #|places d| * #|[set f | turning d f]|).

Check (@mass_formula :
  forall (G : combinatorial_map) (d : G),
  [/\ #|regluings d| =
        (lookalikes d)`! ^ ordinary_edges d * pairings (lookalikes d) ^ semi_edges d,
      #|[set f | turning d f]| =
        \prod_(B in vertex_classes d | d \notin B) (cone_of d B ^ sheets_of B * (sheets_of B)`!) &
      forall x, cone_of d (vertex_class d x) = cone (position_of d) x /\
        sheets_of (vertex_class d x) * cone (position_of d) x = lookalikes d]).

Check (@kinds_of_these_worlds :
  [/\ all planar [:: two_loops_plane; k4_plane; hexagon; triangles; figure_1_left; figure_1_right],
      all (predC planar) [:: two_loops_torus; k4_torus]
    & all simple [:: k4_plane; k4_torus; hexagon; triangles; figure_1_left; figure_1_right]]).

Check (@figure_1_caption_holds :
  as_in_the_caption figure_1_left && as_in_the_caption figure_1_right /\
  ~ same_map (denote figure_1_left) (denote figure_1_right)).

Check (@certificate_suffices :
  forall (P : eqType) (senses : numbered_map -> nat -> P) M N L,
  (map_twin_check senses M N L -> no_explorer_maps_both senses M N) /\
  (twin_check senses M N L -> forall E (meaning : E -> rooted_map) (X : explorer P E),
    ~ (right meaning X (denote M) (senses M) /\ right meaning X (denote N) (senses N)))).

Check (@folding_is_sound :
  forall (L : log) (W : lighthouse_world),
  agrees W L -> forall p q : log_dart L,
  (same_dart p q -> place W p = place W q) /\
  (glued (@next_dart L) (@crossed L) (@sensed_pointed L) p q -> place W q = alpha (place W p))).

Check (@folded_log_is_the_world :
  forall (L : log) (W W' : lighthouse_world), agrees W L -> agrees W' L -> no_open_dart L ->
  exists f : W -> W', [/\ bijective f, forall x, f (sigma x) = sigma (f x),
    forall x, f (alpha x) = alpha (f x), f pointed = pointed &
    forall i, i <= size (steps L) -> f (robot_at L W i) = robot_at L W' i]).

Check (@open_dart_leaves_two_worlds :
  forall (L : log) (W : lighthouse_world) (p : log_dart L), agrees W L -> ~~ dart_settled p ->
  exists W1 W2, [/\ agrees W1 L, agrees W2 L & edges W1 <> edges W2]).

Check (@computed_folding :
  forall (L : log),
  (forall p q : log_dart L,
     (nth 0 (labels L) (dart_number p) == nth 0 (labels L) (dart_number q)) = same_dart p q) /\
  (folds L <-> no_open_dart L)).

Check (@computed_folding_is_the_world :
  forall (L : log) (W : lighthouse_world), agrees W L -> folds L ->
  valid (folded_map L) /\
  isomorphic (denote (folded_map L)) (rooted (@robot_at L W (size (steps L))))).

Check (@open_log_refutes :
  forall u E (meaning : E -> rooted_map) (X : explorer percept E)
    (W : lighthouse_world),
  in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  ~~ folds (log_of W t) -> ~ finds_all_maps u meaning X).

Check (@shield_is_right :
  forall E (X : explorer percept E) (pol : policy) (W : lighthouse_world),
  right_within (as_explorer (shield X (algorithm1 pol))) (M := rooted (@start W)) (@percept_of W)
    (9 * paper_bound (vertices W) (edges W)) /\
  forall budget t e z, episode X (rooted (@start W)) (@percept_of W) budget = (t, e, z) ->
  folds (log_of W t) ->
  right_within (as_explorer (shield X (algorithm1 pol))) (M := rooted (@start W)) (@percept_of W)
    (9 * size t)).

Check (@algorithm1_finds_every_map :
  forall pol u, finds_all_maps u denote (algorithm1 pol)).

Check (@at_least_m_motions :
  forall u E (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) -> edges W <= size t).

Check (@entries_lower_bound :
  forall u E (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps u meaning X -> forall W, in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  edges W + 1 <= vertices W + entries (unzip1 t) (@start W)).

Check (@path_lower_bound :
  forall u E (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps u meaning X -> forall W L budget t e z, in_universe u W ->
  let W' := at_end_of_path L W in
  episode X (rooted (@start W')) (@percept_of W') budget = (t, Some e, z) ->
  2 * L * (edges W + 1 - vertices W) <= size t).

Check (@enumeration_is_sound :
  forall m M, M \in rooted_maps m ->
  [/\ valid M, connected (denote M) & size (sigma_list M) = m.*2]).

Check (@enumeration_is_complete :
  forall (G : combinatorial_map) (d : G),
  exists2 M, M \in rooted_maps (edges G) & isomorphic (rooted d) (denote M)).

Check (@enumeration_has_no_repeats :
  forall m, uniq (rooted_maps m) /\
  forall M N, M \in rooted_maps m -> N \in rooted_maps m -> isomorphic (denote M) (denote N) -> M = N).

Check (@enumeration_counts :
  [seq size (rooted_maps m) | m <- iota 1 5] = [:: 2; 10; 74; 706; 8162]).

Check (@every_explorer_can_be_checked :
  forall O (X : explorer O numbered_map) o seen, as_explorer (remembering X) (o :: seen) = X (o :: seen)).

Check (@certificate_within_paper_bound :
  forall (tree : branches) m, certified tree paper AllWorlds m ->
  forall X, answers_as X tree -> forall W : lighthouse_world, edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (paper_bound (vertices W) (edges W))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@right_explorers_have_certificates :
  forall X limit u m, (forall W : lighthouse_world, in_universe u W -> edges W <= m ->
   right_within X (M := rooted (@start W)) (@percept_of W)
     (limit (vertices W) (edges W) (degree (@start W)))) <->
  exists2 tree, answers_as X tree & certified tree limit u m).

Check (@trees_are_answered :
  forall (tree : branches), exists X, answers_as X tree).

Check (@refutations_are_right :
  forall S (r : resumption S percept) limit u m M k, (M, k) \in directional_refutations r limit u m ->
  exists (V : valid M) (C : connected (denote M)), let W := world_of_numbers V C k in
  [/\ in_universe u W, edges W = m &
      ~ right_within (as_explorer r) (M := rooted (@start W)) (@percept_of W)
          (limit (vertices W) (edges W) (degree (@start W)))]).

Check (@checkers_of_other_lighthouses :
  forall S (r : resumption S (nat * nat)) limit m,
  (cluster_check r limit m <-> forall W : lighthouse_world, one_edge W -> edges W <= m ->
     right_within (as_explorer r) (M := rooted (@start W)) (@cluster_percept W)
       (limit (vertices W) (edges W) (degree (@start W)))) /\
  (natural_check r limit m <-> forall W : lighthouse_world, natural_kind W -> edges W <= m ->
     right_within (as_explorer r) (M := rooted (@start W)) (@natural_percept W)
       (limit (vertices W) (edges W) (degree (@start W))))).

Check (@algorithm1_passes :
  forall pol u m,
  [/\ directional_check (algorithm1_resumption pol) (fun n m _ => paper_limit n m) u m,
      cluster_check (cluster_resumption pol) two_vertices_limit m
    & natural_check (natural_resumption pol) two_vertices_limit m]).

Check (@cluster_right_for_every_schedule :
  forall (W : lighthouse_world), one_edge W ->
  let reached := reached_by coarse (leads_to_v1 (@cluster_percept W) (has_markers 2)) 2 in
  forall q C c, reached q C c ->
  (exists C' c', reached (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= cluster_bound W & robot_knows c])).

Check (@cluster_can_be_laid :
  forall (W : lighthouse_world),
  loops_before W -> one_edge W -> forall pol budget,
  2 * degree (@start W) + cluster_bound W + 3 <= budget -> exists t answer z,
  [/\ carrying_episode 3 (laying_algorithm pol) (@start W) budget
        = (t, Some answer, (z, [:: alpha (@pointed W); alpha (@pointed W); @start W])),
      traversals t <= 2 * degree (@start W) + cluster_bound W, size t = traversals t + 3,
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@cluster_can_be_laid_in_simple_worlds :
  forall (G : combinatorial_map) (d : G), simple_world G ->
  let W := @LighthouseWorld G d d (connect0 _ d) in loops_before W /\ one_edge W).

Check (@movable_marker_is_right :
  forall (G : combinatorial_map) (d : G), one_edge_each G -> forall pol budget,
  edges G * (5 * vertices G + 2 * \max_(x : G) degree x) <= budget -> exists t answer z,
  [/\ carrying_episode 1 (movable pol) d budget = (t, Some answer, (z, [::])),
      size t <= edges G * (5 * vertices G + 2 * \max_(x : G) degree x),
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@markers_do_not_tell_loops :
  forall (G H : combinatorial_map) (d : G) (e : H),
  (forall x y : G, at_same_vertex x y) -> (forall x y : H, at_same_vertex x y) -> degree d = degree e ->
  forall hand A (X : carrying_explorer A) budget,
  (carrying_episode hand X d budget).1 = (carrying_episode hand X e budget).1).

Check (@cluster_needs_one_edge :
  (edges_to_v1 natural_plane = 2 /\ edges_to_v1 natural_torus = 2) /\
  no_explorer_maps_both cluster_percept_in natural_plane natural_torus).

Check (@simple_worlds_have_one_edge :
  forall (W : lighthouse_world), simple_world W -> one_edge W).

Check (@natural_lighthouse_is_right :
  forall (W : lighthouse_world),
  unique (@start W) -> unique (alpha (@pointed W)) -> one_edge W -> forall (pol : policy) budget,
  2 * degree (@start W) + cluster_bound W <= budget -> exists transcript answer z,
  [/\ episode (natural_algorithm (degree (alpha (@pointed W))) pol) (rooted (@start W)) (@degree W)
        budget = (transcript, Some answer, z),
      size transcript <= 2 * degree (@start W) + cluster_bound W,
      valid answer & isomorphic (denote answer) (rooted z)]).

Check (@natural_lighthouse_is_not_enough :
  [/\ all (fun M => map (degree_at M) (iota 0 8) == [:: 2; 2; 6; 6; 6; 6; 6; 6])
          [:: natural_plane; natural_torus],
      edges_to_v1 natural_plane = 2 /\ edges_to_v1 natural_torus = 2
    & no_explorer_maps_both degree_percept natural_plane natural_torus]).

Check (@kinds_of_lighthouse_exist :
  (forall W, one_edge (longer W)) /\
  forall k, [/\ unique (@start (longer (bouquet k))), unique (alpha (@pointed (longer (bouquet k))))
              & one_edge (longer (bouquet k))]).

Check (@primitive_words_leave_no_twins :
  forall w (W W' : lighthouse_world),
  primitive (word w (degree (@start W))) -> ~~ blank (word w (degree (@start W))) ->
  indistinguishable (at_v0 w) W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W')) /\ first_bearing W = first_bearing W').

Check (@other_words_leave_twins :
  forall w d,
  0 < d -> proper_power (word w d) \/ blank (word w d) ->
  exists W W' : lighthouse_world,
  [/\ degree (@start W) = d, indistinguishable (at_v0 w) W W',
      ~ same_map (rooted (@start W)) (rooted (@start W'))
    & no_explorer_finds_both (M := rooted (@start W)) (N := rooted (@start W'))
        (percept_by (at_v0 w) (W := W)) (percept_by (at_v0 w) (W := W'))]).

Check (@each_degree_by_itself :
  forall w d,
  0 < d ->
  sufficient_at (at_v0 w) d <-> primitive (word w d) /\ ~~ blank (word w d)).

Check (@rigid_worlds_have_no_twins :
  forall (A : eqType) (lambda : sensor A) (W W' : lighthouse_world),
  rigid lambda W -> rigid lambda W' -> indistinguishable lambda W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W'))).

Check (@sizes_of_these_twins :
  forall w,
  (forall d k v, 0 < d -> 1 < k -> word w d = flatten (nseq k v) -> exists W W' : lighthouse_world,
   [/\ degree (@start W) = d, edges W = d + k, edges W' = d + k,
       indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))]) /\
  (blank (word w 1) -> exists W W' : lighthouse_world,
   [/\ degree (@start W) = 1, edges W = 2, edges W' = 4,
       indistinguishable (at_v0 w) W W' & ~ same_map (rooted (@start W)) (rooted (@start W'))])).

Check (@letters_are_invariant :
  forall w,
  invariant (at_v0 w) /\ forall (W : lighthouse_world) (d : W),
  at_v0 w pointed d = if bearing d is Some b then w (degree d) b else 0).

Check (@order_of_sensors :
  [/\ sufficient (at_v0 directional_word), strictly_coarser (at_v0 door_word) (at_v0 directional_word),
      ~ sufficient (at_v0 position_word) &
      forall A B (lambda : sensor A) (mu : sensor B),
      coarser lambda mu -> sufficient lambda -> sufficient mu]).

Check (@other_sensors_at_v0 :
  [/\ sufficient (at_v0 half_word), sufficient (at_v0 distance_word) &
      forall q d, 0 < q -> 0 < d ->
      sufficient_at (at_v0 (remainder_word q)) d <-> ~~ ((q %| d) && (q < d))]).

Check (@features_that_suffice :
  forall c,
  invariant (coarsened c) /\
  (sufficient (coarsened c) <-> [|| reason_behind c, reason_edge c | reason_apart c])).

Check (@weakest_sensors :
  [/\ [/\ uniq coarsenings, forall c, exists2 u, u \in coarsenings & same_letters c (nth 0 u) &
        forall u v, u \in coarsenings -> v \in coarsenings -> same_letters (nth 0 u) (nth 0 v) -> u = v],
      [/\ size coarsenings = 203, size sufficing = 131 & size weakest = 24],
      forall u, u \in coarsenings -> u \in sufficing <-> sufficient (coarsened (nth 0 u)) &
      forall u, u \in coarsenings -> u \in weakest <-> sufficient (coarsened (nth 0 u)) /\
      forall c, tells_less (nth 0 u) c -> sufficient (coarsened c) -> tells_less c (nth 0 u)]).

Check (@scanning_is_right :
  forall w (W : lighthouse_world),
  let d := degree (@start W) in
  primitive (word w d) -> ~~ blank (word w d) -> forall (pol : policy) budget,
  let bound := 2 * d + (paper_bound (vertices W) (edges W) + 2 * d * edges W ^ 2) in
  bound <= budget -> exists transcript answer z,
  [/\ episode (scanning_algorithm w pol) (rooted (@start W)) (percept_by (at_v0 w) (W := W)) budget
        = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)]).

Check (@one_explorer_for_all_worlds :
  forall w,
  sufficient (at_v0 w) <->
  exists X : explorer (nat * nat) numbered_map, forall W : lighthouse_world,
  right denote X (rooted (@start W)) (percept_by (at_v0 w) (W := W))).

Check (@door_right_for_every_schedule :
  forall (W : lighthouse_world),
  let reached := reached_by seen_of (@rung W) 2 in
  forall q C c, reached q C c ->
  (exists C' c', reached (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= door_bound W & robot_knows c])).

Check (@cost_of_the_door :
  forall (W : lighthouse_world),
  let n := vertices W in let m := edges W in
  first_bearing W < degree (@start W) /\
  door_bound W + 2 * m = \sum_(1 <= s < n) (s + 2 * s * (2 * m - 2 * (s - 1))) +
    \sum_(1 <= i < (m - (n - 1)).+1) (n + 2 * n * (2 * m - 2 * (n - 1) - 2 * (i - 1)))).

Check (@marker_is_found_from_everywhere :
  forall (W : lighthouse_world) (x : W) E (X : explorer percept E),
  exists t z, at_same_vertex (start : W) z /\ forall budget,
  episode (elsewhere X) (rooted x) (@percept_of W) (size t + budget) =
    let: (t', e, z') := episode X (rooted z) (@percept_of W) budget in (t ++ t', e, z')).

Check (@right_from_everywhere :
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W)) ->
  forall (W : lighthouse_world) (x : W), right meaning (elsewhere X) (rooted x) (@percept_of W)).

Check (@cost_from_elsewhere :
  forall (W : lighthouse_world) (pol : policy) D L (x : W) budget,
  (forall d : W, degree d <= D) -> (exists2 w, size w <= L & at_same_vertex start (walk w x)) ->
  let bound := search_cost D L + paper_bound (vertices W) (edges W) in
  (bound <= budget -> exists transcript answer z,
   [/\ episode (elsewhere (algorithm1 pol)) (rooted x) (@percept_of W) budget = (transcript, Some answer, z),
       size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)]) /\
  (1 < D -> search_cost D L + 8 <= 8 * D ^ L)).

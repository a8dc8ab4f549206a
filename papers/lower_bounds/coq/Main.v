(* ---------------------------------------------------------------------------------------------
   Lower bounds for explorers that find the maps of families of worlds.  The words are explained in
   Model.v of proofs/coq, and at the head of the files named in README.md.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers MassFormula PathWorlds.
From Allworlds Require Import Algorithm.
From Bounds Require Import Matchings Gluings Bouquets Cautious CautiousAlgorithm.
From Bounds Require Import Corridors CorridorWorlds CorridorLogs CorridorBounds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Hetyei: a graph on 2M vertices in which one perfect matching only is left has at most M^2 edges; the
   half graph has as many. *)
Theorem unique_matching_has_few_edges (V : finType) (E : rel V) f :
  symmetric E -> irreflexive E -> only_matching E f -> #|graph_edges E| <= (#|V|./2) ^ 2.
Proof. by move=> s i o; exact: hetyei s i o. Qed.

(* And so many there can be. *)
Theorem half_graph_has_as_many M :
  [/\ symmetric (@half_graph M), irreflexive (@half_graph M), only_matching (@half_graph M) (@across M)
    & #|graph_edges (@half_graph M)| = M ^ 2].
Proof. split; [exact: half_symmetric|exact: half_irreflexive|exact: half_matching|exact: half_graph_reaches_it]. Qed.

(* Bouquets hung up at a distance: v0 of degree 1, joined to a vertex with c = k+1 loops.  There are
   (2c-1)!! of them, all different maps. *)
Theorem worlds_with_hanging_bouquets k :
  #|{: loop_matching k}| = pairings k.*2.+2 /\
  forall a : loop_matching k,
  [/\ edges (hanging a) = k.+2, vertices (hanging a) = 2, degree (@start (hanging a)) = 1 &
  forall a', same_map (rooted (@start (hanging a))) (rooted (@start (hanging a'))) -> a = a'].
Proof. split=> [|a]; first exact: matchings_counted.
by have [m n d] := hanging_sizes a; split=> // a'; exact: same_hanging. Qed.

(* Any explorer, told that it is in one of them: with b motions its logs tell apart tells (b-2) of them at
   most.  tells: 1, 2, 3, 4, 6, 9, 13, ..., each the sum of the one before and the one three before. *)
Theorem told_apart_in_bouquets k E (X : explorer percept E) b (A : {set loop_matching k}) :
  {in A &, injective (fun a : loop_matching k =>
     (episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) b).1)} -> #|A| <= tells (b - 2).
Proof. exact: told_in_bouquets. Qed.

(* So an explorer that finds the maps of all of them makes, in one of them, at least so many motions that
   (2c-1)!! worlds can be told apart: 4, 9, 14, 20, 26 for c = 2, ..., 6. *)
Theorem bouquet_lower_bound k E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall a : loop_matching k, finds_map meaning X (rooted (@start (hanging a))) (@percept_of (hanging a))) ->
  exists a : loop_matching k, forall budget t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  least_motions (pairings k.*2.+2) <= size t.
Proof. exact: bouquet_needs. Qed.

(* What this number is. *)
Theorem least_motions_are_least w b :
  (least_motions w <= b) = (w <= tells (b - 2)).
Proof. exact: least_motionsP. Qed.

(* For two to six loops. *)
Theorem bouquet_bounds_computed :
  [seq least_motions (pairings c.*2) | c <- iota 2 5] = [:: 4; 9; 14; 20; 26].
Proof. exact: least_motions_of_bouquets. Qed.

(* A cautious explorer, once it has crossed a loop from a known end and does not know where it has come out, crosses
   at most one more edge before it goes back, unless that edge leads to v0.  If it finds the maps of all worlds,
   it makes c (2c+1) motions in one of the bouquets with c = k+1 loops. *)
Theorem cautious_explorers_walk_further k E (meaning : E -> rooted_map) (X : explorer percept E) :
  cautious k X ->
  (forall W : lighthouse_world, finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : loop_matching k, forall budget t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t.
Proof. exact: cautious_needs. Qed.

(* Algorithm 1 is one: under every policy it is cautious, and finds the map of every world.  So it makes as many. *)
Theorem algorithm1_is_cautious k pol :
  [/\ cautious k (algorithm1 pol),
      (forall W : lighthouse_world, finds_map denote (algorithm1 pol) (rooted (@start W)) (@percept_of W)) &
  exists a : loop_matching k, forall budget t e z,
  episode (algorithm1 pol) (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t].
Proof. exact: cautious_algorithm1. Qed.

(* Corridors: v0 of degree 2, 2F near hubs, F = f+1 far ones, all of one even degree 12F+6+2e; two edges join each
   to the next, the other darts of near hubs are loops, and those of far ones are matched in any way. *)
Theorem corridors_exist f e :
  [/\ inhabited (near_loops f e), inhabited (far_edges_of f e) &
  forall (g : near_loops f e) (a : far_edges_of f e), let W := camouflaged g a in
  [/\ edges W = 18 * f.+1 ^ 2 + 9 * f.+1 + 1 + 3 * f.+1 * e, vertices W = 3 * f.+1 + 1 &
  exists (y : W) w, 2 * f.+1 < hub y /\ home_word w y]].
Proof. split; [exact: near_loops_exist|exact: far_edges_exist|exact: camouflaged_sizes]. Qed.

(* A home word of a dart leads from it to v0, past no vertex twice: what Algorithm 1 walks in a test.  So does
   what is left of it at any moment, from where the robot is then. *)
Theorem home_words_go_on (W : lighthouse_world) w w' (y : W) : home_word (w ++ w') y -> home_word w' (walk w y).
Proof. exact: home_word_suffix. Qed.

(* In a corridor no far dart is led to v0 by the home word of another dart, near or far, nor by a beginning
   of it: a failed test shows no more than that it failed. *)
Theorem wrong_walkers_stay_away f e (g : near_loops f e) (a : far_edges_of f e) (y y' : camouflaged g a) w t :
  home_word w y -> 2 * f.+1 < hub y' -> y' <> y -> ~~ at_same_vertex start (walk (take t w) y').
Proof. exact: (wrong_walkers (corridor_world_is (valP g) a)). Qed.

(* And home words of different darts, one of them far, differ in one of their first F+1 motions, turns taken
   modulo the degree. *)
Theorem home_words_differ_early f e (g : near_loops f e) (a : far_edges_of f e) (y y' : camouflaged g a) w w' :
  2 * f.+1 < hub y -> home_word w y -> home_word w' y' -> y' <> y ->
  map (modn^~ (12 * f.+1 + 6 + 2 * e)) (take f.+2 w) <> map (modn^~ (12 * f.+1 + 6 + 2 * e)) (take f.+2 w').
Proof. exact: (home_words_part (corridor_world_is (valP g) a)). Qed.

(* Corridors with N near hubs, h+1-N far ones, all of even degree r+1, and 2M darts to be matched: an explorer
   that finds the maps of all of them makes, in one of them, T motions, and the sum of 'C(T, y) 2^y over the
   possible numbers y <= T / (2(N+1)) of returns from far hubs is at least (2M-1)!!. *)
Theorem corridor_lower_bound N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) g (near : near_gluing N out g) :
  N <= h -> ~~ odd r.+1 -> forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_matching N out, let W := corridor_world L near a in
     finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_matching N out, let W := corridor_world L near a in
  [/\ edges W = (h.+1 * r.+1)./2.+1, vertices W = h.+2 & forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  pairings ((h - N) * (r.+1 - 4) + (r.+1 - 2)) <=
    \sum_(y < (size t %/ (2 * N.+1)).+1) 'C(size t, y) * 2 ^ y].
Proof. move=> Nh ev E meaning X H; have [a A] := corridor_costs Nh ev H; exists a; split=> //.
  by rewrite -(doubleK (edges _)) corridor_edges.
exact: corridor_vertices. Qed.

(* The least T that is possible then, w the number of the matchings. *)
Theorem least_in_corridor_is_least N w T :
  (least_in_corridor N w <= T) = (w <= \sum_(y < (T %/ (2 * N.+1)).+1) 'C(T, y) * 2 ^ y).
Proof. by rewrite least_in_corridorP logs_sum. Qed.

(* In the corridors of corridors_exist M = far_pairs_in f e, which is 6F^2+F+1+Fe, pairs of far darts are matched, in
   any of (2M-1)!! ways; these are different maps; and an explorer that finds the maps of all of them makes
   so many motions in one of them. *)
Theorem family_of_corridors f e (g : near_loops f e) :
  [/\ #|{: far_edges_of f e}| = pairings (far_pairs_in f e).*2,
      (forall a a' : far_edges_of f e,
         same_map (rooted (@start (camouflaged g a))) (rooted (@start (camouflaged g a'))) -> a = a') &
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_edges_of f e, let W := camouflaged g a in finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_edges_of f e, let W := camouflaged g a in forall budget t answer z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z) ->
  least_in_corridor (2 * f.+1) (pairings (far_pairs_in f e).*2) <= size t].
Proof.
split; [exact: far_edges_counted|exact: same_corridor|by move=> E meaning X; exact: camouflaged_needs].
Qed.

(* With F = 1, 2, 3 far hubs of degree 12F+6, that is with 28, 91 and 190 edges, at least 30, 216 and 728. *)
Theorem corridor_bounds_computed :
  [/\ least_in_corridor 2 (pairings (far_pairs_in 0 0).*2) = 30,
      least_in_corridor 4 (pairings (far_pairs_in 1 0).*2) = 216 &
      least_in_corridor 6 (pairings (far_pairs_in 2 0).*2) = 728].
Proof. exact: least_in_camouflage. Qed.

(* In closed form, for every F and e: at least (2F+1)(M log(2M-1) - 4) / (1 + log(24(2F+1))) motions, logarithms
   to the base 2 and rounded down.  With m = 3M+6F-2 and n = 3F+1 this is of the order m n log m / log n. *)
Theorem corridor_order f e (g : near_loops f e) E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall a : far_edges_of f e, let W := camouflaged g a in finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_edges_of f e, let W := camouflaged g a in
  let F := f.+1 in let M := far_pairs_in f e in
  [/\ edges W + 2 = 3 * M + 6 * F, vertices W = 3 * F + 1 &
  forall budget t answer z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z) ->
  (2 * F).+1 * (M * trunc_log 2 (M.*2.-1) - 4) <= size t * (trunc_log 2 (24 * (2 * F).+1)).+1].
Proof.
case/camouflaged_order=> a A; have [m n _] := camouflaged_sizes g a; exists a; split=> //.
exact: camouflaged_edges.
Qed.

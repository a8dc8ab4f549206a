(* ---------------------------------------------------------------------------------------------
   The statements of the theorems of Main.v, once more: this file compiles only if each has the statement
   that is written here (see Statements.v of proofs/coq).
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers MassFormula PathWorlds.
From Allworlds Require Import Algorithm.
From Bounds Require Import Matchings Gluings Bouquets Cautious CautiousAlgorithm.
From Bounds Require Import Corridors CorridorWorlds CorridorLogs CorridorBounds.
From Bounds Require Import Main.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Check (@unique_matching_has_few_edges :
  forall (V : finType) (E : rel V) f,
  symmetric E -> irreflexive E -> only_matching E f -> #|graph_edges E| <= (#|V|./2) ^ 2).

Check (@half_graph_has_as_many :
  forall M,
  [/\ symmetric (@half_graph M), irreflexive (@half_graph M), only_matching (@half_graph M) (@across M)
    & #|graph_edges (@half_graph M)| = M ^ 2]).

Check (@worlds_with_hanging_bouquets :
  forall k,
  #|{: loop_matching k}| = pairings k.*2.+2 /\
  forall a : loop_matching k,
  [/\ edges (hanging a) = k.+2, vertices (hanging a) = 2, degree (@start (hanging a)) = 1 &
  forall a', same_map (rooted (@start (hanging a))) (rooted (@start (hanging a'))) -> a = a']).

Check (@told_apart_in_bouquets :
  forall k E (X : explorer percept E) b (A : {set loop_matching k}),
  {in A &, injective (fun a : loop_matching k =>
     (episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) b).1)} -> #|A| <= tells (b - 2)).

Check (@bouquet_lower_bound :
  forall k E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : loop_matching k, finds_map meaning X (rooted (@start (hanging a))) (@percept_of (hanging a))) ->
  exists a : loop_matching k, forall budget t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  least_motions (pairings k.*2.+2) <= size t).

Check (@least_motions_are_least :
  forall w b,
  (least_motions w <= b) = (w <= tells (b - 2))).

Check (@bouquet_bounds_computed :
  [seq least_motions (pairings c.*2) | c <- iota 2 5] = [:: 4; 9; 14; 20; 26]).

Check (@cautious_explorers_walk_further :
  forall k E (meaning : E -> rooted_map) (X : explorer percept E),
  cautious k X ->
  (forall W : lighthouse_world, finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : loop_matching k, forall budget t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t).

Check (@algorithm1_is_cautious :
  forall k pol,
  [/\ cautious k (algorithm1 pol),
      (forall W : lighthouse_world, finds_map denote (algorithm1 pol) (rooted (@start W)) (@percept_of W)) &
  exists a : loop_matching k, forall budget t e z,
  episode (algorithm1 pol) (rooted (@start (hanging a))) (@percept_of (hanging a)) budget = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t]).

Check (@corridors_exist :
  forall f e,
  [/\ inhabited (near_loops f e), inhabited (far_edges_of f e) &
  forall (g : near_loops f e) (a : far_edges_of f e), let W := camouflaged g a in
  [/\ edges W = 18 * f.+1 ^ 2 + 9 * f.+1 + 1 + 3 * f.+1 * e, vertices W = 3 * f.+1 + 1 &
  exists (y : W) w, 2 * f.+1 < hub y /\ home_word w y]]).

Check (@home_words_go_on :
  forall (W : lighthouse_world) w w' (y : W), home_word (w ++ w') y -> home_word w' (walk w y)).

Check (@wrong_walkers_stay_away :
  forall f e (g : near_loops f e) (a : far_edges_of f e) (y y' : camouflaged g a) w t,
  home_word w y -> 2 * f.+1 < hub y' -> y' <> y -> ~~ at_same_vertex start (walk (take t w) y')).

Check (@home_words_differ_early :
  forall f e (g : near_loops f e) (a : far_edges_of f e) (y y' : camouflaged g a) w w',
  2 * f.+1 < hub y -> home_word w y -> home_word w' y' -> y' <> y ->
  map (modn^~ (12 * f.+1 + 6 + 2 * e)) (take f.+2 w) <> map (modn^~ (12 * f.+1 + 6 + 2 * e)) (take f.+2 w')).

Check (@corridor_lower_bound :
  forall N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) g (near : near_gluing N out g),
  N <= h -> ~~ odd r.+1 -> forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_matching N out, let W := corridor_world L near a in
     finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_matching N out, let W := corridor_world L near a in
  [/\ edges W = (h.+1 * r.+1)./2.+1, vertices W = h.+2 & forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  pairings ((h - N) * (r.+1 - 4) + (r.+1 - 2)) <=
    \sum_(y < (size t %/ (2 * N.+1)).+1) 'C(size t, y) * 2 ^ y]).

Check (@least_in_corridor_is_least :
  forall N w T,
  (least_in_corridor N w <= T) = (w <= \sum_(y < (T %/ (2 * N.+1)).+1) 'C(T, y) * 2 ^ y)).

Check (@family_of_corridors :
  forall f e (g : near_loops f e),
  [/\ #|{: far_edges_of f e}| = pairings (far_pairs_in f e).*2,
      (forall a a' : far_edges_of f e,
         same_map (rooted (@start (camouflaged g a))) (rooted (@start (camouflaged g a'))) -> a = a') &
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_edges_of f e, let W := camouflaged g a in finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_edges_of f e, let W := camouflaged g a in forall budget t answer z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z) ->
  least_in_corridor (2 * f.+1) (pairings (far_pairs_in f e).*2) <= size t]).

Check (@corridor_bounds_computed :
  [/\ least_in_corridor 2 (pairings (far_pairs_in 0 0).*2) = 30,
      least_in_corridor 4 (pairings (far_pairs_in 1 0).*2) = 216 &
      least_in_corridor 6 (pairings (far_pairs_in 2 0).*2) = 728]).

Check (@corridor_order :
  forall f e (g : near_loops f e) E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_edges_of f e, let W := camouflaged g a in finds_map meaning X (rooted (@start W)) (@percept_of W)) ->
  exists a : far_edges_of f e, let W := camouflaged g a in
  let F := f.+1 in let M := far_pairs_in f e in
  [/\ edges W + 2 = 3 * M + 6 * F, vertices W = 3 * F + 1 &
  forall budget t answer z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z) ->
  (2 * F).+1 * (M * trunc_log 2 (M.*2.-1) - 4) <= size t * (trunc_log 2 (24 * (2 * F).+1)).+1]).

(* ---------------------------------------------------------------------------------------------
   Pairs of worlds that no explorer can tell apart, each by computation.           Sections III, VIII

     of_neighbours G      a simple graph from the clockwise list of the neighbours of each vertex;
                          the root is the first dart of vertex 0.
     position_percept     position only: the degree, and whether the vertex is the marked one; the
                          marker lies where the robot starts.
     degree_percept       the degree alone.

     planar M, simple M   computed: Euler's formula; no loop and no two edges with the same ends.

     two_loops            position only, two edges: one vertex with two loops, on the
                          sphere and on the torus.
     k4                   position only, simple, six edges: K4 in the plane and on the torus.
     hexagon, triangles   position only, planar and simple, eight edges: v0 joined to opposite corners
                          of a hexagon; v0 joining two triangles.
     figure_1             position only, planar and simple: a pair with all that the caption of
                          Fig. 1 fixes. Which pair was drawn there is a guess.
     natural              Section VIII, a vertex of unique degree next to another: two worlds with
                          loops that have such vertices, of degrees 2 and 6, and cannot be told
                          apart.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model RootedMaps Explorers NumberedWorlds Impossibility.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition at_root M d :=
  has (fun k => iter k (nth 0 (sigma_list M)) d == root_number M) (iota 0 (size (sigma_list M))).
Definition position_percept M d := (degree_at M d, at_root M d).
Definition degree_percept M d := degree_at M d.

Definition of_neighbours (G : seq (seq nat)) :=
  let before v := sumn (take v (map size G)) in
  let darts := flatten [seq [seq (v, i) | i <- iota 0 (size (nth [::] G v))] | v <- iota 0 (size G)] in
  NumberedMap
    [seq before d.1 + d.2.+1 %% size (nth [::] G d.1) | d <- darts]
    [seq let w := nth 0 (nth [::] G d.1) d.2 in before w + index d.1 (nth [::] G w) | d <- darts] 0.

(* the least dart of the cycle of d under f, and the number of cycles *)
Definition least f (d n : nat) := foldr minn d [seq iter k f d | k <- iota 0 n].
Definition cycles f n := count (fun d => least f d n == d) (iota 0 n).
Definition planar M :=
  let n := size (sigma_list M) in
  let sigma := nth 0 (sigma_list M) in let alpha := nth 0 (alpha_list M) in
  cycles sigma n + cycles (sigma \o alpha) n == cycles alpha n + 2.
Definition simple M :=
  let n := size (sigma_list M) in
  let vertex d := least (nth 0 (sigma_list M)) d n in
  let ends := [seq (vertex d, vertex (nth 0 (alpha_list M) d)) | d <- iota 0 n] in
  uniq ends && all (fun p => p.1 != p.2) ends.

Local Notation position_twins M N := (map_twin_check position_percept M N (generated M N)).

(* ---- Position only ---- *)
Definition two_loops_plane := NumberedMap [:: 1; 2; 3; 0] [:: 1; 0; 3; 2] 0.
Definition two_loops_torus := NumberedMap [:: 1; 2; 3; 0] [:: 2; 3; 0; 1] 0.

Lemma two_loops_check : position_twins two_loops_plane two_loops_torus.
Proof. by vm_compute. Qed.

Theorem two_loops_impossible :
  no_explorer_maps_both position_percept two_loops_plane two_loops_torus.
Proof. exact: certified_map_impossible two_loops_check. Qed.

Definition k4_plane := of_neighbours [:: [:: 1; 2; 3]; [:: 0; 3; 2]; [:: 0; 1; 3]; [:: 0; 2; 1]].
Definition k4_torus := of_neighbours [:: [:: 1; 3; 2]; [:: 0; 3; 2]; [:: 0; 1; 3]; [:: 0; 2; 1]].

Lemma k4_check : position_twins k4_plane k4_torus.
Proof. by vm_compute. Qed.

Theorem k4_impossible : no_explorer_maps_both position_percept k4_plane k4_torus.
Proof. exact: certified_map_impossible k4_check. Qed.

Definition hexagon := of_neighbours
  [:: [:: 1; 4]; [:: 0; 2; 6]; [:: 1; 3]; [:: 2; 4]; [:: 0; 5; 3]; [:: 4; 6]; [:: 5; 1]].
Definition triangles := of_neighbours
  [:: [:: 1; 4]; [:: 0; 2; 3]; [:: 1; 3]; [:: 2; 1]; [:: 0; 5; 6]; [:: 4; 6]; [:: 5; 4]].

Lemma hexagon_check : position_twins hexagon triangles.
Proof. by vm_compute. Qed.

Theorem hexagon_impossible : no_explorer_maps_both position_percept hexagon triangles.
Proof. exact: certified_map_impossible hexagon_check. Qed.

(* ---- Fig. 1 ---- *)
Definition figure_1_left := of_neighbours
  [:: [:: 1; 2; 3; 5]; [:: 0; 4; 6]; [:: 0; 6; 7]; [:: 0; 7; 8]; [:: 1; 5; 6]; [:: 0; 8; 4];
      [:: 2; 1; 4]; [:: 3; 2; 8]; [:: 5; 3; 7]].
Definition figure_1_right := of_neighbours
  [:: [:: 1; 2; 3; 5]; [:: 0; 4; 6]; [:: 0; 6; 4]; [:: 0; 7; 8]; [:: 1; 2; 6]; [:: 0; 8; 7];
      [:: 2; 1; 4]; [:: 3; 5; 8]; [:: 5; 3; 7]].

Lemma figure_1_check : position_twins figure_1_left figure_1_right.
Proof. by vm_compute. Qed.

Theorem figure_1_impossible :
  no_explorer_maps_both position_percept figure_1_left figure_1_right.
Proof. exact: certified_map_impossible figure_1_check. Qed.

(* 'Same motion sequences always result in same perceptions in both graphs' *)
Theorem figure_1_same_episode E (X : explorer _ E) budget :
  (episode X (denote figure_1_left) (position_percept figure_1_left) budget).1 =
  (episode X (denote figure_1_right) (position_percept figure_1_right) budget).1.
Proof. by apply: (@certified_episode _ _ _ _ (generated figure_1_left figure_1_right)); vm_compute. Qed.

(* 'not isomorphic to each other under the extended definition' *)
Theorem figure_1_different : ~ same_map (denote figure_1_left) (denote figure_1_right).
Proof. by apply: differ; vm_compute. Qed.

(* the caption: the motions 1, 1, 2, 2, 1 sense [3,A] four times, then [4,P], facing any edge of v0 *)
Definition sensed_on_the_way M w d :=
  [seq position_percept M (walk_in (denote M) (take k w) d) | k <- iota 1 (size w)].
Arguments sensed_on_the_way : clear implicits.
Definition as_in_the_caption M :=
  all (fun k => sensed_on_the_way M [:: 1; 1; 2; 2; 1] (iter k (nth 0 (sigma_list M)) 0) ==
    [:: (3, false); (3, false); (3, false); (3, false); (4, true)]) (iota 0 4).

Lemma figure_1_caption : as_in_the_caption figure_1_left && as_in_the_caption figure_1_right.
Proof. by vm_compute. Qed.

(* what kind of maps these are *)
Lemma kinds :
  [/\ all planar [:: two_loops_plane; k4_plane; hexagon; triangles; figure_1_left; figure_1_right],
      all (predC planar) [:: two_loops_torus; k4_torus]
    & all simple [:: k4_plane; k4_torus; hexagon; triangles; figure_1_left; figure_1_right]].
Proof. by vm_compute. Qed.

(* ---- A natural lighthouse ---- *)

(* v0 with darts 0, 1; v1 with darts 2 .. 7 clockwise; edges 0-2 and 1-5, and two loops *)
Definition natural_plane := NumberedMap [:: 1; 0; 3; 4; 5; 6; 7; 2] [:: 2; 5; 0; 4; 3; 1; 7; 6] 0.
Definition natural_torus := NumberedMap [:: 1; 0; 3; 4; 5; 6; 7; 2] [:: 2; 5; 0; 7; 6; 1; 4; 3] 0.

Lemma natural_degrees : all (fun M => map (degree_at M) (iota 0 8) == [:: 2; 2; 6; 6; 6; 6; 6; 6])
  [:: natural_plane; natural_torus].
Proof. by vm_compute. Qed.

Lemma natural_check : map_twin_check degree_percept natural_plane natural_torus
  (generated natural_plane natural_torus).
Proof. by vm_compute. Qed.

Theorem natural_impossible :
  no_explorer_maps_both degree_percept natural_plane natural_torus.
Proof. exact: certified_map_impossible natural_check. Qed.

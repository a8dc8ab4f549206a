(* ---------------------------------------------------------------------------------------------
   The marker cluster: undirected markers, one at v0 and two at a neighbour v1.    Sections IV and VIII

   The robot senses the degree and how many markers lie at the vertex, no direction; one edge joins v0
   and v1.  This is an instance of TwoVertices.v.

     marks d              how many markers lie at the vertex of d.
     cluster_percept d    what is sensed: the degree and the number of markers.
     one_edge             exactly one edge joins v0 and v1, the vertex at the other end of `pointed`: no
                          other dart of v0 leads to v1.  simple_one_edge: so it is in simple worlds.
     cluster_bound        (1)+(2) and two traversals for each test, 2 m^2 in all.
     same_vertex_in, cluster_percept_in, edges_to_v1   the same for worlds written as lists.
     cluster, cluster_algorithm pol   the lighthouse, and the explorer.

     cluster_runs         the algorithm with any schedule: it can be finished, and then it is right.
     cluster_correct      the explorer, under every policy, with any budget of at least (1)+(2), two
                          traversals a test and 2 deg(v0) for the search: it stops within that, and
                          is right.
     cluster_hypotheses_met   worlds in which one_edge holds.
     two_edges_impossible     with two edges between v0 and v1 no explorer finds the maps of all worlds.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Cost Correctness Lighthouses.
From Allworlds Require Import Algorithm NumberedWorlds Impossibility Twins PathWorlds TwoVertices.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition one_edge (W : lighthouse_world) := forall d : W,
  at_same_vertex start d -> at_same_vertex (alpha pointed) (alpha d) -> d = pointed.

Lemma simple_one_edge (W : lighthouse_world) : simple_world W -> one_edge W.
Proof.
move=> S d c c1; apply: S; last by rewrite at_same_vertex_sym.
rewrite at_same_vertex_sym; apply: connect_trans c; rewrite -/(at_same_vertex _ _).
by rewrite at_same_vertex_sym; exact: pointed_at_v0.
Qed.

(* a loop at v0 joins v0 and v1 = v0 twice, once from each end *)
Lemma one_edge_apart (W : lighthouse_world) : one_edge W -> ~~ at_same_vertex (@start W) (alpha pointed).
Proof.
move=> H; apply/negP=> c; have := @alpha_neq W pointed; rewrite (H _ c) ?eqxx //.
rewrite alphaK at_same_vertex_sym; apply: connect_trans c.
by rewrite -/(at_same_vertex _ _) at_same_vertex_sym pointed_at_v0.
Qed.

Definition has_markers n (o : nat * nat) := o.2 == n.
Definition cluster : lighthouse (nat * nat) [eqType of bool] :=
  two_vertices fst (has_markers 1) (has_markers 2).
Definition cluster_algorithm := explorer_by cluster.

Section Cluster.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation v1 := (alpha (@pointed W)).

Definition marks (d : W) := if at_same_vertex v0 d then 1 else if at_same_vertex v1 d then 2 else 0.
Definition cluster_percept d := (degree d, marks d).

(* two traversals for each test: in pass p at most 2m-2p-1, so m^2 in all *)
Definition cluster_bound := paper_bound (vertices W) (edges W) + 2 * edges W ^ 2.

Hypothesis one : one_edge W.

Lemma one_marker d : has_markers 1 (cluster_percept d) = at_same_vertex v0 d.
Proof. by rewrite /has_markers /= /marks; case: ifP => // _; case: ifP. Qed.

Lemma two_markers d : has_markers 2 (cluster_percept d) = at_same_vertex v1 d.
Proof.
rewrite /has_markers /= /marks; case: ifP => [c|_]; last by case: ifP.
apply/esym/negbTE/negP=> c1; case/negP: (one_edge_apart one).
by rewrite at_same_vertex_sym in c1; exact: connect_trans c c1.
Qed.

Local Notation leads_to_v1 := (leads_to_v1 cluster_percept (has_markers 2)).

Theorem cluster_runs q C c : reached_by coarse leads_to_v1 2 q C c ->
  (exists C' c', reached_by coarse leads_to_v1 2 (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= cluster_bound & robot_knows c]).
Proof.
exact: (@two_vertices_runs W _ cluster_percept fst (has_markers 1) (has_markers 2)
  (fun=> erefl) one_marker two_markers one).
Qed.

Theorem cluster_resumed pol : exists t answer z,
  [/\ machine cluster pol motion cluster_percept (size t) (Return (knowledge_at_v0 (degree v0)
        (first_bearing W) (opposite (degree v0) (first_bearing W)))) (@pointed W) = (t, Some answer, z),
      size t <= cluster_bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
exact: (@two_vertices_resumed W _ cluster_percept fst (has_markers 1) (has_markers 2)
  (fun=> erefl) one_marker two_markers one).
Qed.

Theorem cluster_correct pol budget : 2 * degree v0 + cluster_bound <= budget ->
  exists transcript answer z,
  [/\ episode (cluster_algorithm pol) (rooted v0) cluster_percept budget
        = (transcript, Some answer, z),
      size transcript <= 2 * degree v0 + cluster_bound,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
exact: (@two_vertices_correct W _ cluster_percept fst (has_markers 1) (has_markers 2)
  (fun=> erefl) one_marker two_markers one).
Qed.
End Cluster.

(* ---- The hypothesis can be met: an edge before the start of any world is the only one at v0 ---- *)
Lemma longer_start W (d : longer W) : at_same_vertex (@start (longer W)) d -> d = start.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->. Qed.

Theorem cluster_hypotheses_met W : one_edge (longer W).
Proof. by move=> d /longer_start. Qed.

(* ---- and it is needed ---- *)

(* in worlds written as lists: v0 at the root, v1 at the other end of its edge *)
Definition same_vertex_in M d e :=
  has (fun k => iter k (nth 0 (sigma_list M)) d == e) (iota 0 (size (sigma_list M))).
Definition cluster_percept_in M d :=
  (degree_at M d, if same_vertex_in M (root_number M) d then 1
   else if same_vertex_in M (nth 0 (alpha_list M) (root_number M)) d then 2 else 0).
Definition edges_to_v1 M :=
  count (fun d => same_vertex_in M (root_number M) d &&
    same_vertex_in M (nth 0 (alpha_list M) (root_number M)) (nth 0 (alpha_list M) d))
    (iota 0 (size (sigma_list M))).

Lemma two_edges_between : edges_to_v1 natural_plane = 2 /\ edges_to_v1 natural_torus = 2.
Proof. by vm_compute. Qed.

Lemma two_edges_check : map_twin_check cluster_percept_in natural_plane natural_torus
  (generated natural_plane natural_torus).
Proof. by vm_compute. Qed.

Theorem two_edges_impossible :
  no_explorer_maps_both cluster_percept_in natural_plane natural_torus.
Proof. exact: certified_map_impossible two_edges_check. Qed.

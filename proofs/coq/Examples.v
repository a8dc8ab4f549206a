(* ---------------------------------------------------------------------------------------------
   The hypotheses can be met: worlds, and runs computed inside Coq.

     figure_eight, theta, k4, lollipop   one vertex with two loops; two vertices with three edges; K4; an
                               edge with a loop at its end.
     run, run_machine          Algorithm 1 from the root, as explorer and step by step: the number of
                               traversals, and whether it is right.
     cluster_run, natural_run, door_run   the same with the lighthouses without a direction; with a door.
     theta_world               a lighthouse_world; theta_is_met: the theorem of Refinement.v about
                               it.
     loop_on_cycle             a loop lies on a cycle, so DoubleCover.v speaks of worlds that
                               exist.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Cost Algorithm.
From Allworlds Require Import Refinement Policies NumberedWorlds Judge DoubleCover Enumeration.
From Allworlds Require Import Cluster NaturalLighthouse SameWorld Checker Door.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition figure_eight := NumberedMap [:: 1; 2; 3; 0] [:: 1; 0; 3; 2] 0.
Definition theta := NumberedMap [:: 1; 2; 0; 4; 5; 3] [:: 3; 5; 4; 0; 2; 1] 0.
Definition k4 :=
  NumberedMap [:: 1; 2; 0; 4; 5; 3; 7; 8; 6; 10; 11; 9] [:: 3; 6; 9; 0; 11; 7; 1; 5; 10; 2; 8; 4] 0.

Lemma theta_valid : valid theta. Proof. by vm_compute. Qed.

Lemma theta_order : size (dart_order theta) == size (sigma_list theta). Proof. by vm_compute. Qed.

(* the run for the marker k darts clockwise from the root: its cost, and whether it is right *)
Definition run pol M k :=
  let pt := iter k (nth 0 (sigma_list M)) (root_number M) in
  let: (transcript, answer, z) := episode (algorithm1 pol) (denote M) (sensed M pt) 100 in
  (size transcript, if answer is Some e then same_code e (seen_from M z) else false).
Definition run_machine pol M k :=
  let pt := iter k (nth 0 (sigma_list M)) (root_number M) in
  let: (transcript, answer, z) :=
    machine directional pol (motion_in (denote M)) (sensed M pt) 100
      (Return (first_knowledge (sensed M pt (root_number M)))) (root_number M) in
  (size transcript, if answer is Some e then same_code e (seen_from M z) else false).
Definition runs (f : policy -> numbered_map -> nat -> nat * bool) pol M :=
  [seq f pol M k | k <- iota 0 (degree_at M (root_number M))].

(* a policy that proposes nothing legal *)
Definition unhelpful :=
  Policy (fun _ => (7, 7)) (fun _ _ => [:: 1; 5]) (fun _ _ _ => [::]) (fun _ _ => [:: 3]).

Example figure_eight_runs : runs run fifo figure_eight = nseq 4 (2, true).
Proof. by vm_compute. Qed.
Example theta_runs : runs run fifo theta = nseq 3 (8, true).
Proof. by vm_compute. Qed.
Definition policies := [:: fifo; lifo; nearest; unhelpful].
Example k4_runs : all (fun pol => all (fun r => r.2) (runs run pol k4)) policies.
Proof. by vm_compute. Qed.
Example machine_runs : all (fun M => runs run_machine fifo M == runs run fifo M)
  [:: figure_eight; theta; k4].
Proof. by vm_compute. Qed.

(* an answer with the right map and the wrong place, and one with the wrong map, are not right *)
Example judge_tells : [/\ judge theta 0 theta = IsRight,
  judge figure_eight 0 (seen_from figure_eight 1) = WrongPose
  & judge theta 0 figure_eight = WrongMap].
Proof. by vm_compute. Qed.

(* ---- Lighthouses without a direction: v1 is at the other end of the root's edge ---- *)
Definition judged (O : Type) (B : eqType) (L : lighthouse O B) pol senses M :=
  let d := root_number M in
  let: (transcript, answer, z) :=
    machine L pol (motion_in (denote M)) (senses M) 200 (set_out L (senses M d)) d in
  (size transcript, if answer is Some e then same_code e (seen_from M z) else false).
Definition cluster_run pol M := judged cluster pol cluster_percept_in M.
(* begun k darts further round v0, so that v1 has to be searched *)
Definition cluster_run_from k pol M :=
  judged cluster pol (fun _ => cluster_percept_in M)
    (seen_from M (iter k (nth 0 (sigma_list M)) (root_number M))).
Definition natural_run pol b M := judged (natural (degree_at M (root_number M)) b) pol degree_at M.

(* every world up to three edges in which one edge joins v0 and v1 *)
Definition one_edge_worlds :=
  [seq M <- flatten [seq rooted_maps m | m <- iota 1 3] | edges_to_v1 M == 1].

Example cluster_runs : size one_edge_worlds = 30 /\
  all (fun pol => all (fun M => all (fun k => (cluster_run_from k pol M).2)
    (iota 0 (degree_at M (root_number M)))) one_edge_worlds) policies.
Proof. by vm_compute. Qed.
(* with three edges between v0 and v1: the same explorer ends with another map *)
Example cluster_errs : cluster_run fifo theta = (12, false).
Proof. by vm_compute. Qed.

(* an edge with a loop at its end, begun at the other end *)
Definition lollipop := NumberedMap [:: 0; 2; 3; 1] [:: 1; 0; 3; 2] 0.
Example natural_runs : natural_run fifo 3 lollipop = (7, true).
Proof. by vm_compute. Qed.

(* v0 of degree 2 between a leaf, which it faces, and v1, which has a loop *)
Definition between := NumberedMap [:: 1; 0; 3; 4; 2; 5] [:: 2; 5; 0; 4; 3; 1] 1.
Example natural_searches : [seq natural_run pol 3 between | pol <- policies]
  = [:: (11, true); (10, true); (11, true); (11, true)].
Proof. by vm_compute. Qed.

(* ---- The door, k darts clockwise from the root ---- *)
Definition door_run k pol M := let pt := iter k (nth 0 (sigma_list M)) (root_number M) in
  judged door pol (fun M d => seen_of (sensed M pt d)) M.
Definition door_limit k M := 2 * k + paper_limit (vertices_in M) (edges_in M) + 2 * edges_in M ^ 2.
Example door_runs : all (fun pol => all (fun M => all (fun k =>
    let: (cost, right) := door_run k pol M in right && (cost <= door_limit k M))
  (iota 0 (degree_at M (root_number M)))) (flatten [seq rooted_maps m | m <- iota 1 3])) policies.
Proof. by vm_compute. Qed.
(* the limit is met *)
Definition three_loops := NumberedMap [:: 1; 2; 3; 4; 5; 0] [:: 1; 0; 3; 2; 5; 4] 0.
Example door_limit_is_met : door_run 5 lifo three_loops = (31, true) /\ door_limit 5 three_loops = 31.
Proof. by vm_compute. Qed.

Definition theta_world := world_of_numbers theta_valid (elimT (connectedP theta_valid) theta_order) 1.

Theorem theta_is_met : exists transcript answer z,
  [/\ episode (algorithm1 fifo) (rooted start) (@percept_of theta_world)
        (paper_bound (vertices theta_world) (edges theta_world)) = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by have [t [e [z [A _ V I]]]] := algorithm1_correct (W := theta_world) fifo (leqnn _);
  exists t, e, z. Qed.

Theorem loop_on_cycle (G : combinatorial_map) (e : G) : at_same_vertex e (alpha e) -> on_cycle e.
Proof.
rewrite at_same_vertex_sym; apply: connect_sub => x y /eqP <-.
by apply: connect1; rewrite /step_without_e eqxx.
Qed.

(* ---------------------------------------------------------------------------------------------
   Lighthouses without a direction: two neighbours v0 and v1 that the robot can tell from all other
   vertices and from each other, joined by exactly one edge.                  Sections IV and VIII

   The dart of v0 that leads to v1 stands for the pointed dart.  Where Algorithm 1 compares a bearing,
   at the end of a test that has come to v0, the robot leaves by the dart that should lead to v1, looks,
   and comes back: two traversals, and a match if and only if it has seen v1.  Before the first pass it
   looks for that dart, trying the darts of v0 one after the other: 2 deg(v0) traversals at most.

     degree_seen, is_v0, is_v1   what the robot takes from a percept.
     one_edge             exactly one edge joins v0 and v1; so v1 is not v0.
     coarse o             of a percept with a bearing: the degree, and whether the vertex is v0.
     query S f            the motion by the dart that should lead to v1, if the robot is at f.
     leads_to_v1 S f y    it does, from dart y.
     search n k left c    leave v0, which has n darts, by the dart in place k; if it leads to v1 that
                          is the dart, else try the next, as long as any are left.
     two_vertices         the lighthouse, for the program.
     confirmed_iff        a test is confirmed if and only if its hypothesis is true.
     two_vertices_runs    for every schedule: what Lighthouses.v says.
     two_vertices_resumed, two_vertices_correct   for the program, under every policy: the same, once
                          the dart to v1 is known, and the search included.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps HypothesisTests.
From Allworlds Require Import Pass Correctness Lighthouses Algorithm Queue Execution OnePass.
From Allworlds Require Import Refinement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition coarse (o : percept) := (o.1, isSome o.2).

(* ---- The program ---- *)
Section Program.
Variables (O : Type) (degree_seen : O -> nat) (is_v0 is_v1 : O -> bool).

Fixpoint search n k left c : program O knowledge :=
  if left is left'.+1 then
    Go c (fun o => Go 0 (fun _ =>
      if is_v1 o then Return (knowledge_at_v0 n k (opposite n k)) else search n k.+1 left' 1))
  else Return (knowledge_at_v0 n 0 0).

Definition asked k f := odflt 0 (expected_percept (bearing0 k) (known_map k) f).2.

Definition two_vertices : lighthouse O [eqType of bool] :=
  {| set_out := fun o => let n := degree_seen o in search n 0 n 0;
     reads := fun o => (degree_seen o, is_v0 o);
     foretells := coarse;
     confirm := fun k f c => Go (c + asked k f) (fun o => Go 0 (fun _ =>
       Return (is_v1 o, opposite (degree_in (known_map k) f.1) (asked k f)))) |}.
End Program.

(* ---- In a world ---- *)
Section InWorld.
Variables (W : lighthouse_world) (O : Type) (senses : W -> O).
Variables (degree_seen : O -> nat) (is_v0 is_v1 : O -> bool).
Local Notation v0 := (@start W).
Local Notation v1 := (alpha (@pointed W)).
Local Notation b := (first_bearing W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).

Hypothesis degree_sensed : forall d, degree_seen (senses d) = degree d.
Hypothesis v0_sensed : forall d, is_v0 (senses d) = at_same_vertex v0 d.
Hypothesis v1_sensed : forall d, is_v1 (senses d) = at_same_vertex v1 d.
Hypothesis one_edge : forall d, at_same_vertex v0 d -> at_same_vertex v1 (alpha d) -> d = pointed.

Definition query S (f : dart) := odflt 0 (expected_percept b S f).2.
Definition leads_to_v1 S f y := is_v1 (senses (motion (query S f) y)).

Lemma reads_coarse d : (degree_seen (senses d), is_v0 (senses d)) = coarse (percept_of d).
Proof.
rewrite degree_sensed v0_sensed /coarse /percept_of /bearing /=; congr (_, _).
have -> : at_same_vertex d pointed = at_same_vertex v0 d.
  rewrite at_same_vertex_sym /at_same_vertex.
  by rewrite (same_connect (fconnect_sym sigma_inj) (@pointed_at_v0 W)).
by case: ifP.
Qed.

Lemma only_pointed d : at_same_vertex v0 d -> at_same_vertex v1 (alpha d) = (d == pointed).
Proof. by move=> c; apply/idP/eqP=> [|->]; [exact: one_edge | exact: connect0]. Qed.

Theorem confirmed_iff S r h w f (x : W) : embedded S r -> known S h -> follow S w h = Some f ->
  f.1 = 0 -> matches coarse leads_to_v1 S x (h, w) f <-> x = phi r h.
Proof.
move=> I kh R f0; have [kf E] := follow_phi I kh R.
have Bf : bearing (phi r f) = Some (query S f).
  by have := expected_percept_phi I kf; rewrite /query /expected_percept f0 /= => -[_ <-].
have at_pointed : iter (query S f) sigma (phi r f) = pointed.
  by move: Bf; rewrite /bearing; case: ifP => // c [<-]; exact: iter_findex.
rewrite /matches /leads_to_v1 /motion v1_sensed; split=> [/andP[lk Q]|->]; last first.
  by rewrite /looks /foretold /= (truth_matches I kh R) eqxx E at_pointed; exact: connect0.
apply: (@walk_inj _ w); rewrite E; apply: (@iter_sigma_inj _ (query S f)); rewrite at_pointed.
have : is_v0 (senses (walk w x)).
  by have := congr1 snd (looks_last I kh R lk); rewrite -reads_coarse /= Bf.
rewrite v0_sensed => c; apply: one_edge => //; apply: connect_trans c _; exact: fconnect_iter.
Qed.

Theorem two_vertices_runs q C c : reached_by coarse leads_to_v1 2 q C c ->
  (exists C' c', reached_by coarse leads_to_v1 2 (edges W) C' c' /\ nothing_open c') /\
  (nothing_open c -> [/\ q = edges W, C <= bound_by W 2 & robot_knows c]).
Proof.
by move=> R; split; [have := run_by_completes confirmed_iff R | have := run_by_correct confirmed_iff R].
Qed.

(* ---- The program there ---- *)
Local Notation L := (two_vertices degree_seen is_v0 is_v1).
Local Notation makes := (makes senses).

Lemma asks k f (y : W) c d : bearing0 k = b -> f.1 = 0 ->
  degree y = degree_in (known_map k) f.1 -> due c d y -> exists c' z,
  makes (confirm L k f c) d (leads_to_v1 (known_map k) f y, c') z 2 /\ due c' z y.
Proof.
move=> kb f0 D du; rewrite /= /asked kb -/(query _ _); set q := query _ _.
exists (opposite (degree y) q), (iter q sigma y); split; last exact: opposite_turn.
apply: makes_go; rewrite (motion_due _ du); apply: makes_go.
by rewrite /motion /= alphaK D; exact: makes_return.
Qed.

Lemma search_makes left k c d : due c d (iter k sigma v0) -> k <= b -> b < k + left ->
  exists z, makes (search is_v1 (degree v0) k left c) d
    (knowledge_at_v0 (degree v0) b (opposite (degree v0) b)) z (2 * (b - k).+1) /\
  due (opposite (degree v0) b) z v0.
Proof.
elim: left k c d => [|left IH] k c d du kb bk; first by move: bk; rewrite addn0 ltnNge kb.
have Y : motion c d = alpha (iter k sigma v0) by rewrite /motion du.
have seen : is_v1 (senses (motion c d)) = (k == b).
  rewrite Y v1_sensed only_pointed; last exact: fconnect_iter.
  apply/eqP/eqP=> [P|->]; last exact: iter_findex (@pointed_at_v0 W).
  rewrite /first_bearing -P findex_iter //; apply: leq_ltn_trans kb _.
  exact: findex_max (@pointed_at_v0 W).
rewrite /=; case: (k =P b) seen => [E seen|/eqP nkb seen].
  exists (iter b sigma v0); split; last exact: opposite_turn.
  rewrite E subnn; apply: makes_go; apply: makes_go; rewrite seen Y E /motion /= alphaK.
  exact: makes_return.
have kb' : k < b by rewrite ltn_neqAle nkb.
have [|||z [A du']] := IH k.+1 1 (iter k sigma v0) => //; first by rewrite addSn -addnS.
exists z; split=> //; rewrite -(subnSK kb') mulnS; apply: makes_go; apply: makes_go.
by rewrite seen Y /motion /= alphaK.
Qed.

Lemma sets_out : exists k z,
  makes (set_out L (senses v0)) v0 k z (2 * b.+1) /\ knows k (initial W) z.
Proof.
have [|||z [A du]] := @search_makes (degree v0) 0 0 v0 => //.
  exact: findex_max (@pointed_at_v0 W).
exists (knowledge_at_v0 (degree v0) b (opposite (degree v0) b)), z.
by rewrite /= degree_sensed -{3}[b]subn0; split=> //; split=> //; exact: queue_initial.
Qed.

(* once the dart that leads to v1 is known *)
Theorem two_vertices_resumed pol : exists t answer z,
  [/\ machine L pol motion senses (size t)
        (Return (knowledge_at_v0 (degree v0) b (opposite (degree v0) b))) (@pointed W)
        = (t, Some answer, z),
      size t <= bound_by W 2, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
apply: (@resumed_correct W O _ L pol senses leads_to_v1 2 reads_coarse (fun=> erefl) asks
  confirmed_iff); split=> //; first exact: queue_initial.
by rewrite /= -(iter_findex (@pointed_at_v0 W)); exact: opposite_turn.
Qed.

Local Notation bound := (2 * degree v0 + bound_by W 2).

Theorem two_vertices_correct pol budget : bound <= budget -> exists transcript answer z,
  [/\ episode (explorer_by L pol) (rooted v0) senses budget = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
have le : 2 * b.+1 + bound_by W 2 <= bound.
  by rewrite leq_add2r leq_mul2l /=; exact: findex_max (@pointed_at_v0 W).
move/(leq_trans le)=> H.
have [t [e [z [A s V J]]]] := @explorer_by_correct W O _ L pol senses leads_to_v1 2 reads_coarse
  (fun=> erefl) asks confirmed_iff (2 * b.+1) sets_out budget H.
by exists t, e, z; split=> //; exact: leq_trans s le.
Qed.
End InWorld.

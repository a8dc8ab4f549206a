(* ---------------------------------------------------------------------------------------------
   The marker cluster: undirected markers, one at v0 and two at a neighbour v1.    Sections IV and VIII

   The robot senses the degree and how many markers lie at the vertex, no direction.  The dart of v0
   that leads to v1 stands for the pointed dart.  The robot knows it at the start, since it has laid
   the markers; a search for it, of 2 deg(v0) traversals at most, is not counted here.  Where
   Algorithm 1 compares a bearing, at the end of a test that has come to v0, the robot leaves by the
   dart that should lead to v1, looks, and comes back: two traversals, and a match if and only if it
   sees two markers.

     marks d              how many markers lie at the vertex of d.
     cluster_percept d    what is sensed: the degree and the number of markers.
     apart, one_edge      v1 is not v0, and exactly one edge joins them.
     coarse o             of a percept with a bearing: the degree and whether v0 is marked so.
                          coarse_sensed: a robot with the cluster senses as much.
     looks_like_home S x t   what is sensed on the way of the test t, begun in x, is what S foretells.
     query S f            the motion by the dart that should lead to v1, if the robot is at f.
     confirmed S x t f    the test matches throughout, the query included.
     test_cost S x t      traversals of a test that fails, the way back and the query included.
     cluster_pass, cluster_reached   as pass and reached in Pass.v.

     confirmed_iff        a test is confirmed if and only if its hypothesis is true.
     cluster_pass_is_pass every pass is a pass of Algorithm 1 with a directional marker.
     cluster_progress     while a dart is open there is a next pass.
     cluster_pass_cost    each test costs at most two traversals more.
     cluster_correct      a run that leaves no dart open has made m passes; the map is the world, the pose
                          is right, and the cost is at most (1)+(2) and 2 (2m-2p-1) for every pass p.
     cluster_completes    there is such a run.
     cluster_hypotheses_met  worlds in which apart and one_edge hold.
   --------------------------------------------------------------------------------------------- *)
From Coq Require Import Lia.
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps PartialMaps HypothesisTests Paths Pass Cost
  Correctness.
From Allworlds Require Import LowerBounds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma cost_arithmetic s a k l K t : a < s -> t <= (2 * (s - 1) + 2) * k -> l <= s - 1 -> 
  k.+2 <= K ->
  a + 1 + t + (l + 2) <= s + 2 * (s - 1) * K + 2 * (K - 1).
Proof.
move=> /leP h1 /leP h2 /leP h3 /leP h4; apply/leP; move: h1 h2 h3 h4.
by rewrite -!(plusE, multE, minusE); nia.
Qed.

Lemma cost_arithmetic_vertex s a k K t : a < s -> t <= (2 * (s - 1) + 2) * k -> k < K ->
  a + 1 + t <= s + 2 * (s - 1) * K + 2 * (K - 1).
Proof.
move=> /leP h1 /leP h2 /leP h3; apply/leP; move: h1 h2 h3.
by rewrite -!(plusE, multE, minusE); nia.
Qed.

Section Cluster.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation v1 := (alpha (@pointed W)).
Local Notation b := (first_bearing W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).

Hypothesis apart : ~~ at_same_vertex v0 v1.
Hypothesis one_edge : forall d, at_same_vertex v0 d -> at_same_vertex v1 (alpha d) -> d = pointed.

Definition marks (d : W) := if at_same_vertex v0 d then 1 else if at_same_vertex v1 d then 2 else 0.
Definition cluster_percept d := (degree d, marks d).

Definition coarse (o : percept) := (o.1, isSome o.2).

Lemma coarse_sensed d : coarse (percept_of d) = ((cluster_percept d).1, (cluster_percept d).2 == 1).
Proof.
rewrite /coarse /cluster_percept /marks /percept_of /bearing /=; congr (_, _).
have -> : at_same_vertex d pointed = at_same_vertex v0 d.
  rewrite at_same_vertex_sym /at_same_vertex.
  by rewrite (same_connect (fconnect_sym sigma_inj) (@pointed_at_v0 W)).
by case: ifP => // _; case: ifP.
Qed.

Definition looks_like_home S (x : W) (t : dart * seq nat) :=
  map coarse (percepts_along t.2 x) == map coarse (expected_percepts b S t.2 t.1).
Definition query S (f : dart) := odflt 0 (expected_percept b S f).2.
Definition confirmed S x t f :=
  looks_like_home S x t && (marks (motion (query S f) (walk t.2 x)) == 2).
Definition test_cost S (x : W) (t : dart * seq nat) :=
  if looks_like_home S x t then 2 * size t.2 + 2
  else 2 * find (fun q => q.1 != q.2)
    (zip (map coarse (percepts_along t.2 x)) (map coarse (expected_percepts b S t.2 t.1))).

Section Embedded.
Variables (S : partial_map) (r : seq W).
Hypothesis I : embedded S r.

Lemma marks_v1 d : (marks (alpha d) == 2) && at_same_vertex v0 d = (d == pointed).
Proof.
apply/andP/eqP=> [[]|->]; last first.
  by rewrite /marks (negbTE apart) /at_same_vertex connect0; split=> //; exact: pointed_at_v0.
by rewrite /marks; case: ifP => // _; case: ifP => // c _ c0; exact: one_edge.
Qed.

Theorem confirmed_iff h w f x : known S h -> follow S w h = Some f -> f.1 = 0 ->
  confirmed S x (h, w) f <-> percepts_along w x = expected_percepts b S w h.
Proof.
move=> kh R f0; have [kf E] := follow_phi I kh R.
have Bf : bearing (phi r f) = Some (query S f).
  by have := expected_percept_phi I kf; rewrite /query /expected_percept f0 /= => -[_ <-].
have at_pointed : iter (query S f) sigma (phi r f) = pointed.
  by move: Bf; rewrite /bearing; case: ifP => // c [<-]; exact: iter_findex.
split=> [/andP[/eqP T Q]|T].
  suff -> : x = phi r h by exact: (truth_matches I kh R).
  apply: (@walk_inj _ w); rewrite E; apply: (@iter_sigma_inj _ (query S f)); rewrite at_pointed.
  apply/eqP; rewrite -marks_v1 -/(motion _ _) Q /=.
  have V : coarse (percept_of (walk w x)) = coarse (percept_of (phi r f)).
    have := congr1 (last (0, false)) T; rewrite (expected_percepts_phi I kh R) /=.
    have lastE d : last (0, false) (map coarse (percepts_along w d)) =
      coarse (percept_of (walk w d)).
      have := percepts_last w d (0, None); case: (percepts_along w d) (size_percepts w d) =>
        // o s _ /=.
      by rewrite (last_map coarse) => ->.
    by rewrite !lastE E.
  have : isSome (bearing (walk w x)) by have := congr1 snd V; rewrite /coarse /= Bf.
  rewrite /bearing; case: ifP => // c _; apply: (@connect_trans _ _ (walk w x));
    last exact: fconnect_iter.
  apply: connect_trans (@pointed_at_v0 W) _; by rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
rewrite /confirmed /looks_like_home /= T eqxx /= (match_proves I kh R f0 T) E /motion at_pointed.
by have := marks_v1 pointed; rewrite eqxx => /andP[].
Qed.
End Embedded.

Definition cluster_rejected S e (x : W) (t : dart * seq nat) :=
  [/\ is_open S t.1, t.1 != e & exists2 f, leads_home S t.1 t.2 f & ~~ confirmed S x t f].

Inductive cluster_pass (e : dart) : configuration W -> nat -> configuration W -> Prop :=
| ClusterLoopPass S c p w0 k ts h w f :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> cluster_rejected S e x t) -> uniq (h :: unzip1 ts) ->
    is_open S h -> h != e -> leads_home S h w f -> confirmed S x (h, w) f ->
    cluster_pass e (Configuration S c p)
      (size w0 + 1 + \sum_(t <- ts) test_cost S x t + (size w + 2))
      (Configuration (add_loop S e h) f (walk w x))
| ClusterVertexPass S c p w0 k ts :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> cluster_rejected S e x t) -> uniq (unzip1 ts) ->
    (forall h, is_open S h -> h != e ->
       coarse (expected_percept b S h) = coarse (percept_of x) -> h \in unzip1 ts) ->
    cluster_pass e (Configuration S c p) (size w0 + 1 + \sum_(t <- ts) test_cost S x t)
      (Configuration (add_vertex S e (cluster_percept x).1) (new_dart S) x).

Inductive cluster_reached : nat -> nat -> configuration W -> Prop :=
| ClusterReachedStart : cluster_reached 0 0 (initial W)
| ClusterReachedPass n C e c C1 c' :
    cluster_reached n C c -> cluster_pass e c C1 c' -> cluster_reached n.+1 (C + C1) c'.

Lemma cluster_rejected_rejected S r e x t : embedded S r -> cluster_rejected S e x t ->
  rejected S e x t.
Proof.
case: t => h w I [/= oh he [f [R f0 sw] N]]; have [kh _] := andP oh; split=> //; first by exists f.
by move/(confirmed_iff I x kh R f0); apply/negP.
Qed.

Theorem cluster_pass_is_pass e c C c' : sound c -> cluster_pass e c C c' ->
  exists C0, pass e c C0 c'.
Proof.
move=> Ok P; case: P Ok => S d p w0 k ts => [h w f|] x Tr Rj U.
  move=> oh he Hf V [r [/= I _ _ _]]; eexists; apply: (LoopPass Tr _ U oh he Hf).
    by move=> t mt; exact: (cluster_rejected_rejected I (Rj t mt)).
  by have [kh _] := andP oh; have [R f0 _] := Hf; apply/(confirmed_iff I _ kh R f0).
move=> H [r [/= I _ _ _]]; eexists; apply: (VertexPass Tr _ U).
  by move=> t mt; exact: (cluster_rejected_rejected I (Rj t mt)).
by move=> h oh he E; apply: H => //; rewrite E.
Qed.

Lemma pass_transit e (c : configuration W) C c' :
  pass e c C c' -> exists w0 k, transit (mapped c) (here c) e w0 k.
Proof. by case=> S d p w0 k ts => [h w f|] x Tr *; exists w0, k. Qed.

Theorem cluster_progress e c : sound c -> is_open (mapped c) e ->
  exists C c', cluster_pass e c C c'.
Proof.
case: c => S d p Ok oe; have [C [c' P]] := pass_progress Ok oe; have [r [/= I kd pd Rc]] := Ok.
have [w0 [k Tr]] := pass_transit P; rewrite /= in Tr.
set x := motion k (walk w0 p).
case: (boolP (has (fun h => phi r h == x) (darts S))) => [/hasP[h]|/hasPn N].
  rewrite mem_darts => kh /eqP E.
  have [oh he] := other_end I oe kh (esym (etrans E (arrival I kd pd Tr))).
  have [w [f Hf]] := home I Rc kh; have [Rw f0 _] := Hf.
  do 2 eexists; apply: (@ClusterLoopPass e S d p w0 k [::] h w f Tr) => //.
  by apply/(confirmed_iff I _ kh Rw f0); rewrite -/x -E; exact: (truth_matches I kh Rw).
have [h|ts [tsE tsP]] := @list_choice _ _ (fun h w => cluster_rejected S e x (h, w))
    [seq h <- open_darts S | h != e].
  rewrite mem_filter mem_open_darts => /andP[he oh]; have [kh _] := andP oh.
  have [w [f Hf]] := home I Rc kh; have [Rw f0 _] := Hf; exists w; split=> //; exists f => //.
  apply/negP=> /(confirmed_iff I _ kh Rw f0) V; have E := match_proves I kh Rw f0 V.
  by have := N h; rewrite mem_darts E eqxx => /(_ kh).
do 2 eexists; apply: (@ClusterVertexPass e S d p w0 k ts Tr).
- by move=> -[h w] /tsP.
- by rewrite tsE filter_uniq ?open_darts_uniq.
by move=> h oh he _; rewrite tsE mem_filter he mem_open_darts.
Qed.

(* ---- Cost ---- *)
Local Notation m := (edges W).
Local Notation n := (vertices W).

Lemma test_cost_le S e x t : cluster_rejected S e x t ->
  test_cost S x t <= 2 * (size (degrees S) - 1) + 2.
Proof.
case: t => h w [/= oh he [f [Rw f0 sw] _]]; rewrite /test_cost /=.
have sw' : size w <= size (degrees S) - 1 by rewrite subn1 -ltnS prednK // (leq_ltn_trans _ sw).
case: ifP => [_|/negbT /eqP ne]; first by rewrite leq_add2r leq_mul2l sw' orbT.
apply: (@leq_trans (2 * (size (degrees S) - 1))); last exact: leq_addr.
rewrite leq_mul2l /=; apply: leq_trans sw'.
have sz : size (map coarse (percepts_along w x)) = size (map coarse (expected_percepts b S w h)).
  by rewrite !size_map size_percepts (size_expected W Rw).
have := unequal_lists sz ne.
by rewrite has_find size_zip -sz minnn size_map size_percepts ltnS.
Qed.

Theorem cluster_pass_cost e (c : configuration W) C c' p : sound c ->
  is_open (mapped c) e -> size (links (mapped c)) = p.*2 -> cluster_pass e c C c' ->
  C <= pass_bound m (size (degrees (mapped c))) p + 2 * (2 * m - 2 * p - 1).
Proof.
move=> Ok oe sz P; case: P Ok oe sz => S d q w0 k ts => [h w f|] x [_ sw0 _] Rj U.
all: have sum : \sum_(t <- ts) test_cost S x t <= (2 * (size (degrees S) - 1) + 2) * size ts
  by apply: (@leq_trans (\sum_(t <- ts) (2 * (size (degrees S) - 1) + 2)));
  [rewrite !big_seq; apply: leq_sum => t mt; exact: (test_cost_le (Rj t mt))
  |rewrite big_const_seq count_predT iter_addn_0].
- move=> oh he [_ _ sw] V [r [/= I _ _ _]] oe sz.
  have H : size [:: e, h & unzip1 ts] <= 2 * m - 2 * p.
    apply: (hypotheses_le I sz).
      rewrite cons_uniq U andbT inE negb_or eq_sym he /=.
      by apply/mapP=> -[t mt et]; have [_ /eqP[]] := Rj t mt; rewrite et.
    move=> h'; rewrite !inE => /or3P[/eqP->//|/eqP->//|/mapP[t mt ->]]; by case: (Rj t mt).
  rewrite /= size_map in H.
  have sw' : size w <= size (degrees S) - 1 by rewrite subn1 -ltnS prednK // (leq_ltn_trans _ sw).
  exact: (cost_arithmetic sw0 sum sw' H).
move=> _ [r [/= I _ _ _]] oe sz.
have H : size (e :: unzip1 ts) <= 2 * m - 2 * p.
  apply: (hypotheses_le I sz).
    by rewrite cons_uniq U andbT; apply/mapP=> -[t mt et]; have [_ /eqP[]] := Rj t mt; rewrite et.
  by move=> h'; rewrite inE => /orP[/eqP->//|/mapP[t mt ->]]; case: (Rj t mt).
rewrite /= size_map in H; exact: (cost_arithmetic_vertex sw0 sum H).
Qed.

Definition cluster_bound q := run_bound n m q + \sum_(0 <= p < q) 2 * (2 * m - 2 * p - 1).

Lemma cluster_reached_reached q C c : cluster_reached q C c -> exists C0, reached q C0 c.
Proof.
elim=> [|k C0 e c1 C1 c2 _ [C2 R] P]; first by exists 0; exact: ReachedStart.
have [C3 P'] := cluster_pass_is_pass (reached_sound R) P.
by exists (C2 + C3); exact: ReachedPass R P'.
Qed.

Lemma cluster_pass_open e c C c' : cluster_pass e c C c' -> is_open (mapped c) e.
Proof. by case=> ? ? ? ? ? ? => [? ? ?|] x []. Qed.

Theorem cluster_cost q C c : cluster_reached q C c -> C <= cluster_bound q.
Proof.
elim=> [|p C0 e c1 C1 c2 R0 Cb P]; first by rewrite /cluster_bound /run_bound !big_geq.
have [C2 R] := cluster_reached_reached R0.
rewrite /cluster_bound /run_bound !big_nat_recr //= addnACA leq_add //.
have H := cluster_pass_cost (reached_sound R) (cluster_pass_open P) (reached_links R) P.
apply: leq_trans H _; rewrite leq_add2r; apply: pass_bound_mono;
  rewrite leq_min (reached_size R) /=.
by have [r [I _ _ _]] := reached_sound R; exact: (size_vertices I).
Qed.

Theorem cluster_correct q C c : cluster_reached q C c -> nothing_open c ->
  [/\ q = m, C <= paper_bound n m + \sum_(0 <= p < m) 2 * (2 * m - 2 * p - 1) & robot_knows c].
Proof.
move=> R0 nopen; have [C0 R] := cluster_reached_reached R0; have [E _ K] := run_correct R nopen.
split=> //; have := cluster_cost R0; rewrite /cluster_bound E run_bound_paper //.
  exact: (vertices_gt0 v0).
have [r [I _ _ _]] := reached_sound R.
rewrite -E leq_subLR add1n (leq_trans _ (reached_size R)) //.
exact: complete_vertices I (complete_when_nothing_open I nopen).
Qed.
Theorem cluster_completes : exists C c, cluster_reached m C c /\ nothing_open c.
Proof.
suff H q C c : cluster_reached q C c ->
    exists C' c', cluster_reached m C' c' /\ nothing_open c'.
  exact: H ClusterReachedStart.
have [N] := ubnP (m - q); elim: N q C c => // N IH q C c lN R0.
have [C0 R] := cluster_reached_reached R0.
case: (boolP (has (fun e => is_open (mapped c) e) (PartialMaps.darts (mapped c)))) => [|/hasPn H].
  case/hasP=> e _ oe; have [C1 [c1 P]] := cluster_progress (reached_sound R) oe.
  have R1 := ClusterReachedPass R0 P; have [C2 R2] := cluster_reached_reached R1.
  apply: (IH _ _ _ _ R1); rewrite ltnS in lN; apply: leq_trans lN.
  by apply: ltn_sub2l => //; exact: (run_passes R2).
have nopen : nothing_open c.
  move=> e; apply/negP=> oe; have [ke _] := andP oe.
  by have := H e; rewrite mem_darts oe => /(_ ke).
by have [<- _ _] := cluster_correct R0 nopen; exists C, c.
Qed.
End Cluster.

(* the hypotheses can be met: an edge before the start of any world is the only one at v0 *)
Section Met.
Variable W : lighthouse_world.
Local Notation L := (longer W).

Lemma longer_start d : at_same_vertex (@start L) d -> d = start.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= k ->. Qed.

Theorem cluster_hypotheses_met :
  ~~ at_same_vertex (@start L) (alpha pointed) /\
  forall d : L, at_same_vertex start d -> at_same_vertex (alpha pointed) (alpha d) -> d = pointed.
Proof. by split=> [|d /longer_start //]; apply/negP=> /longer_start. Qed.
End Met.

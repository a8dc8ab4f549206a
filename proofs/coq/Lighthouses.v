(* ---------------------------------------------------------------------------------------------
   Algorithm 1 with another lighthouse, as a relation.                          Sections IV and VIII

   With a directional lighthouse a test compares bearings.  Another lighthouse may show less of what S
   foretells on the way, and ask for something more to be done at v0, at the end of a test: what must
   remain is that a test matches if and only if its hypothesis is true.

     foretells o          what of the percept o, bearing included, is compared.
     confirms S f y       what is done at v0 besides, where a test has come to y and S says dart f,
                          succeeds; it takes confirm_cost traversals, and the robot is at y again.
     looks S x t          what is sensed on the way of the test t, begun in x, is what S foretells.
     matches S x t f      the test matches, `confirms` at its last dart f included.
     failed_cost S x t    traversals of a test that fails, the way back included.
     pass_by, reached_by  as pass and reached in Pass.v.
     foretold, refuted    what S foretells of a test; the test of a hypothesis that does not match.
     bound_by             (1)+(2) and confirm_cost for each test, confirm_cost m^2 in all.
     decides              a test matches if and only if its hypothesis is true.

   If it does:
     pass_by_is_pass      every pass is a pass of Algorithm 1 with a directional marker.
     pass_by_progress     while a dart is open there is a next pass.
     pass_by_cost         each test costs at most confirm_cost traversals more.
     run_by_correct       a run that leaves no dart open has made m passes; the map is the world, the
                          pose is right, and the cost is at most bound_by.
     run_by_completes     every run can be continued to such an end.
     directional_pass     with the paper's lighthouse a pass_by is a pass, with the same cost.
   --------------------------------------------------------------------------------------------- *)
From Coq Require Import Lia.
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts PartialMaps HypothesisTests Pass Cost Correctness.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma loop_arithmetic c s a k l K t : a < s -> t <= (2 * (s - 1) + c) * k -> l <= s - 1 ->
  k.+2 <= K -> a + 1 + t + (l + c) <= s + 2 * (s - 1) * K + c * (K - 1).
Proof.
move=> /leP h1 /leP h2 /leP h3 /leP h4; apply/leP; move: h1 h2 h3 h4.
by rewrite -!(plusE, multE, minusE); nia.
Qed.

Lemma vertex_arithmetic c s a k K t : a < s -> t <= (2 * (s - 1) + c) * k -> k < K ->
  a + 1 + t <= s + 2 * (s - 1) * K + c * (K - 1).
Proof.
move=> /leP h1 /leP h2 /leP h3; apply/leP; move: h1 h2 h3.
by rewrite -!(plusE, multE, minusE); nia.
Qed.

(* c for each test that can be made: in pass p at most 2m-2p-1 *)
Lemma tests_of_a_run m c : \sum_(0 <= p < m) c * (2 * m - 2 * p - 1) = c * m ^ 2.
Proof.
rewrite -big_distrr /=; congr (c * _); elim: m => [|m IH]; first by rewrite big_geq.
rewrite big_nat_recl //= (eq_bigr (fun i => 2 * m - 2 * i - 1)).
  by rewrite IH muln0 subn0 !expnS !expn0 !muln1 -!(plusE, multE, minusE); nia.
by move=> i _; rewrite !mulnS subnDl.
Qed.

Section Lighthouses.
Variables (W : lighthouse_world) (B : eqType) (foretells : percept -> nat * B).
Variables (confirms : partial_map -> dart -> W -> bool) (confirm_cost : nat).
Local Notation v0 := (@start W).
Local Notation b := (first_bearing W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).

Definition foretold S (t : dart * seq nat) := map foretells (expected_percepts b S t.2 t.1).
Definition looks S (x : W) (t : dart * seq nat) :=
  map foretells (percepts_along t.2 x) == foretold S t.
Definition matches S (x : W) (t : dart * seq nat) f := looks S x t && confirms S f (walk t.2 x).
Definition failed_cost S (x : W) (t : dart * seq nat) :=
  if looks S x t then 2 * size t.2 + confirm_cost
  else 2 * find (fun q => q.1 != q.2) (zip (map foretells (percepts_along t.2 x)) (foretold S t)).
Definition refuted S e (x : W) (t : dart * seq nat) :=
  [/\ is_open S t.1, t.1 != e & exists2 f, leads_home S t.1 t.2 f & ~~ matches S x t f].

Inductive pass_by (e : dart) : configuration W -> nat -> configuration W -> Prop :=
| LoopPassBy S c p w0 k ts h w f :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> refuted S e x t) -> uniq (h :: unzip1 ts) ->
    is_open S h -> h != e -> leads_home S h w f -> matches S x (h, w) f ->
    pass_by e (Configuration S c p)
      (size w0 + 1 + \sum_(t <- ts) failed_cost S x t + (size w + confirm_cost))
      (Configuration (add_loop S e h) f (walk w x))
| VertexPassBy S c p w0 k ts :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> refuted S e x t) -> uniq (unzip1 ts) ->
    (forall h, is_open S h -> h != e ->
       foretells (expected_percept b S h) = foretells (percept_of x) -> h \in unzip1 ts) ->
    pass_by e (Configuration S c p) (size w0 + 1 + \sum_(t <- ts) failed_cost S x t)
      (Configuration (add_vertex S e (percept_of x).1) (new_dart S) x).

Inductive reached_by : nat -> nat -> configuration W -> Prop :=
| ReachedByStart : reached_by 0 0 (initial W)
| ReachedByPass n C e c C1 c' :
    reached_by n C c -> pass_by e c C1 c' -> reached_by n.+1 (C + C1) c'.

(* where a test has matched S foretells what is sensed *)
Lemma looks_last S r h w f (x : W) : embedded S r -> known S h -> follow S w h = Some f ->
  looks S x (h, w) -> foretells (percept_of (walk w x)) = foretells (percept_of (phi r f)).
Proof.
move=> I kh R /eqP; rewrite /foretold /= (expected_percepts_phi I kh R).
have [_ <-] := follow_phi I kh R => /(congr1 (last (foretells (0, None)))).
by rewrite !last_map !percepts_last.
Qed.

Hypothesis decides : forall S r h w f x, embedded S r -> known S h -> follow S w h = Some f ->
  f.1 = 0 -> matches S x (h, w) f <-> x = phi r h.

(* ---- Each pass is a pass of Algorithm 1 ---- *)
Lemma refuted_rejected S r e x t : embedded S r -> refuted S e x t -> rejected S e x t.
Proof.
case: t => h w I [/= oh he [f [R f0 sw] N]]; have [kh _] := andP oh; split=> //; first by exists f.
by move/(match_proves I kh R f0)=> E; case/negP: N; exact/(decides _ I kh R f0).
Qed.

Theorem pass_by_is_pass e c C c' : sound c -> pass_by e c C c' -> exists C0, pass e c C0 c'.
Proof.
move=> Ok P; case: P Ok => S d p w0 k ts => [h w f|] x Tr Rj U.
  move=> oh he Hf V [r [/= I _ _ _]]; eexists; apply: (LoopPass Tr _ U oh he Hf).
    by move=> t mt; exact: (refuted_rejected I (Rj t mt)).
  have [kh _] := andP oh; have [R f0 _] := Hf.
  by rewrite -(truth_matches I kh R) -((decides _ I kh R f0).1 V).
move=> H [r [/= I _ _ _]]; eexists; apply: (VertexPass Tr _ U).
  by move=> t mt; exact: (refuted_rejected I (Rj t mt)).
by move=> h oh he E; apply: H => //; rewrite E.
Qed.

Theorem pass_by_progress e c : sound c -> is_open (mapped c) e -> exists C c', pass_by e c C c'.
Proof.
case: c => S d p [r [/= I kd pd Rc]] oe; have [w0 [k Tr]] := transit_to I Rc kd oe.
set x := motion k (walk w0 p).
case: (boolP (has (fun h => phi r h == x) (darts S))) => [/hasP[h]|/hasPn N].
  rewrite mem_darts => kh /eqP E.
  have [oh he] := other_end I oe kh (esym (etrans E (arrival I kd pd Tr))).
  have [w [f Hf]] := home I Rc kh; have [Rw f0 _] := Hf.
  do 2 eexists; apply: (@LoopPassBy e S d p w0 k [::] h w f Tr) => //.
  by apply/(decides _ I kh Rw f0); rewrite E.
have [h|ts [tsE tsP]] := @list_choice _ _ (fun h w => refuted S e x (h, w))
    [seq h <- open_darts S | h != e].
  rewrite mem_filter mem_open_darts => /andP[he oh]; have [kh _] := andP oh.
  have [w [f Hf]] := home I Rc kh; have [Rw f0 _] := Hf; exists w; split=> //; exists f => //.
  apply/negP=> /(decides _ I kh Rw f0) E.
  by have := N h; rewrite mem_darts -E eqxx => /(_ kh).
do 2 eexists; apply: (@VertexPassBy e S d p w0 k ts Tr).
- by move=> -[h w] /tsP.
- by rewrite tsE filter_uniq ?open_darts_uniq.
by move=> h oh he _; rewrite tsE mem_filter he mem_open_darts.
Qed.

(* ---- Cost ---- *)
Local Notation m := (edges W).
Local Notation n := (vertices W).

Lemma failed_cost_le S e x t : refuted S e x t ->
  failed_cost S x t <= 2 * (size (degrees S) - 1) + confirm_cost.
Proof.
case: t => h w [/= oh he [f [Rw f0 sw] _]]; rewrite /failed_cost /=.
have sw' : size w <= size (degrees S) - 1 by rewrite subn1 -ltnS prednK // (leq_ltn_trans _ sw).
case: ifP => [_|/negbT /eqP ne]; first by rewrite leq_add2r leq_mul2l sw' orbT.
apply: (@leq_trans (2 * (size (degrees S) - 1))); last exact: leq_addr.
rewrite leq_mul2l /=; apply: leq_trans sw'.
have sz : size (map foretells (percepts_along w x)) = size (foretold S (h, w)).
  by rewrite !size_map size_percepts (size_expected W Rw).
have := unequal_lists sz ne.
by rewrite has_find size_zip -sz minnn size_map size_percepts ltnS.
Qed.

Theorem pass_by_cost e (c : configuration W) C c' p : sound c ->
  is_open (mapped c) e -> size (links (mapped c)) = p.*2 -> pass_by e c C c' ->
  C <= pass_bound m (size (degrees (mapped c))) p + confirm_cost * (2 * m - 2 * p - 1).
Proof.
move=> Ok oe sz P; case: P Ok oe sz => S d q w0 k ts => [h w f|] x [_ sw0 _] Rj U.
all: have sum : \sum_(t <- ts) failed_cost S x t <=
    (2 * (size (degrees S) - 1) + confirm_cost) * size ts
  by apply: (@leq_trans (\sum_(t <- ts) (2 * (size (degrees S) - 1) + confirm_cost)));
  [rewrite !big_seq; apply: leq_sum => t mt; exact: (failed_cost_le (Rj t mt))
  |rewrite big_const_seq count_predT iter_addn_0].
- move=> oh he [_ _ sw] V [r [/= I _ _ _]] oe sz.
  have H : size [:: e, h & unzip1 ts] <= 2 * m - 2 * p.
    apply: (hypotheses_le I sz).
      rewrite cons_uniq U andbT inE negb_or eq_sym he /=.
      by apply/mapP=> -[t mt et]; have [_ /eqP[]] := Rj t mt; rewrite et.
    move=> h'; rewrite !inE => /or3P[/eqP->//|/eqP->//|/mapP[t mt ->]]; by case: (Rj t mt).
  rewrite /= size_map in H.
  have sw' : size w <= size (degrees S) - 1 by rewrite subn1 -ltnS prednK // (leq_ltn_trans _ sw).
  exact: (loop_arithmetic sw0 sum sw' H).
move=> _ [r [/= I _ _ _]] oe sz.
have H : size (e :: unzip1 ts) <= 2 * m - 2 * p.
  apply: (hypotheses_le I sz).
    by rewrite cons_uniq U andbT; apply/mapP=> -[t mt et]; have [_ /eqP[]] := Rj t mt; rewrite et.
  by move=> h'; rewrite inE => /orP[/eqP->//|/mapP[t mt ->]]; case: (Rj t mt).
rewrite /= size_map in H; exact: (vertex_arithmetic sw0 sum H).
Qed.

Definition confirmations_cost q := \sum_(0 <= p < q) confirm_cost * (2 * m - 2 * p - 1).
Definition bound_by := paper_bound n m + confirm_cost * m ^ 2.

Lemma reached_by_reached q C c : reached_by q C c -> exists C0, reached q C0 c.
Proof.
elim=> [|k C0 e c1 C1 c2 _ [C2 R] P]; first by exists 0; exact: ReachedStart.
have [C3 P'] := pass_by_is_pass (reached_sound R) P.
by exists (C2 + C3); exact: ReachedPass R P'.
Qed.

Lemma pass_by_open e c C c' : pass_by e c C c' -> is_open (mapped c) e.
Proof. by case=> ? ? ? ? ? ? => [? ? ?|] x []. Qed.

Theorem run_by_cost q C c : reached_by q C c -> C <= run_bound n m q + confirmations_cost q.
Proof.
elim=> [|p C0 e c1 C1 c2 R0 Cb P]; first by rewrite /run_bound /confirmations_cost !big_geq.
have [C2 R] := reached_by_reached R0.
rewrite /run_bound /confirmations_cost !big_nat_recr //= addnACA leq_add //.
have H := pass_by_cost (reached_sound R) (pass_by_open P) (reached_links R) P.
apply: leq_trans H _; rewrite leq_add2r; apply: pass_bound_mono;
  rewrite leq_min (reached_size R) /=.
by have [r [I _ _ _]] := reached_sound R; exact: (size_vertices I).
Qed.

Theorem run_by_correct q C c : reached_by q C c -> nothing_open c ->
  [/\ q = m, C <= bound_by & robot_knows c].
Proof.
move=> R0 nopen; have [C0 R] := reached_by_reached R0; have [E _ K] := run_correct R nopen.
split=> //; have := run_by_cost R0; rewrite E /confirmations_cost tests_of_a_run run_bound_paper //.
  exact: (vertices_gt0 v0).
have [r [I _ _ _]] := reached_sound R.
rewrite -E leq_subLR add1n (leq_trans _ (reached_size R)) //.
exact: complete_vertices I (complete_when_nothing_open I nopen).
Qed.

Theorem run_by_completes q C c : reached_by q C c ->
  exists C' c', reached_by m C' c' /\ nothing_open c'.
Proof.
have [N] := ubnP (m - q); elim: N q C c => // N IH q C c lN R0.
have [C0 R] := reached_by_reached R0.
case: (boolP (has (fun e => is_open (mapped c) e) (PartialMaps.darts (mapped c)))) => [|/hasPn H].
  case/hasP=> e _ oe; have [C1 [c1 P]] := pass_by_progress (reached_sound R) oe.
  have R1 := ReachedByPass R0 P; have [C2 R2] := reached_by_reached R1.
  apply: (IH _ _ _ _ R1); rewrite ltnS in lN; apply: leq_trans lN.
  by apply: ltn_sub2l => //; exact: (run_passes R2).
have nopen : nothing_open c.
  move=> e; apply/negP=> oe; have [ke _] := andP oe.
  by have := H e; rewrite mem_darts oe => /(_ ke).
by have [<- _ _] := run_by_correct R0 nopen; exists C, c.
Qed.
End Lighthouses.

(* ---- The paper's lighthouse: bearings are compared, and nothing else is to be done ---- *)
Section Directional.
Variable W : lighthouse_world.
Local Notation always := (fun _ _ (_ : W) => true).
Local Notation pass_by := (@pass_by W [eqType of option nat] id always 0).

Lemma directional_matches S (x : W) t f :
  matches id always S x t f = (percepts_along t.2 x == expected_percepts (first_bearing W) S t.2 t.1).
Proof. by rewrite /matches /looks /foretold !map_id andbT. Qed.

Lemma directional_rejected S e (x : W) t : refuted id always S e x t -> rejected S e x t.
Proof.
by case=> o ne [f Hf]; rewrite directional_matches => /eqP N; split=> //; exists f.
Qed.

Lemma directional_cost S e (x : W) ts : (forall t, t \in ts -> refuted id always S e x t) ->
  \sum_(t <- ts) failed_cost id 0 S x t = tests_cost S x ts.
Proof.
move=> H; rewrite /tests_cost !big_seq; apply: eq_bigr => t /H[_ _ [f _ N]].
rewrite /failed_cost /steps_walked /foretold !map_id; case: ifP => // lk.
by rewrite /matches lk in N.
Qed.

Theorem directional_pass e c C c' : pass_by e c C c' -> pass e c C c'.
Proof.
case=> S d p w0 k ts => [h w f|] x Tr Rj U.
  move=> oh he Hf; rewrite directional_matches (directional_cost Rj) addn0 => /eqP V.
  by apply: (LoopPass Tr _ U oh he Hf V) => t mt; exact: (directional_rejected (Rj t mt)).
move=> H; rewrite (directional_cost Rj).
apply: (VertexPass Tr _ U) => [t mt|]; [exact: directional_rejected (Rj t mt) | exact: H].
Qed.
End Directional.

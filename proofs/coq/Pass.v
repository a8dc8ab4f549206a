(* ---------------------------------------------------------------------------------------------
   A pass through the loop of Algorithm 1, as a relation.                 Algorithm 1, lines 2-21

   Nothing that the paper leaves open is fixed here.  Any open dart may leave U (line 3); any path
   of fewer steps than S has vertices may lead to it and from a hypothesis to v0 (a simple path is
   one; lines 4, 9); the hypotheses may be tested in any order (line 8); and hypotheses of another
   signature may be tested or left out (line 6).

     configuration        what is mapped, the robot's dart in S, and its true dart in the world.
     transit S c e w k    lines 3-4: e is open; the motions w lead in S from c to the vertex of e,
                          and from there motion k leaves by e.
     leads_home S h w f   lines 8-9: the motions w lead in S from h to v0, into its dart f.
     rejected S e x t     the hypothesis t.1, tested from the true dart x with the motions t.2, fails.
     steps_walked         steps made in a test until the first mismatch.
     tests_cost           traversals of a list of rejected tests: there and back (line 15).
     pass e c C c'        exploring e takes the configuration c to c', with C traversals: all of
                          lines 4-21, either with a confirmed hypothesis h (LoopPass) or with all
                          hypotheses of the signature seen rejected (VertexPass).
     reached n C c        c is reached from the start by some n passes with C traversals in all.

     sound c              S is embedded in the world (I-1 and I-2), the robot is where it believes
                          to be.
     pass_sound           every pass keeps this, whatever the choices.  Section V, item 2.
     pass_progress        while U is not empty, every open dart can be explored: no run is stuck.
     pass_explores_one_edge, pass_decreases_variant     Section V, item 3: t falls, by one.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts PartialMaps HypothesisTests Paths.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Pass.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).
Local Notation b := (first_bearing W).

Record configuration := Configuration { mapped : partial_map; here : dart; robot : W }.

Definition transit S (c e : dart) w k :=
  [/\ is_open S e, size w < size (degrees S) & exists2 g, follow S w c = Some g & turn S k g = e].
Definition leads_home S (h : dart) w f :=
  [/\ follow S w h = Some f, f.1 = 0 & size w < size (degrees S)].
Definition rejected S e (x : W) (t : dart * seq nat) :=
  [/\ is_open S t.1, t.1 != e, exists f, leads_home S t.1 t.2 f &
      percepts_along t.2 x <> expected_percepts b S t.2 t.1].
Definition steps_walked S (x : W) (t : dart * seq nat) :=
  find (fun q => q.1 != q.2) (zip (percepts_along t.2 x) (expected_percepts b S t.2 t.1)).
Definition tests_cost S x ts := \sum_(t <- ts) 2 * steps_walked S x t.

Inductive pass (e : dart) : configuration -> nat -> configuration -> Prop :=
| LoopPass S c p w0 k ts h w f :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> rejected S e x t) -> uniq (h :: unzip1 ts) ->
    is_open S h -> h != e -> leads_home S h w f ->
    percepts_along w x = expected_percepts b S w h ->
    pass e (Configuration S c p) (size w0 + 1 + tests_cost S x ts + size w)
           (Configuration (add_loop S e h) f (walk w x))
| VertexPass S c p w0 k ts :
    let x := motion k (walk w0 p) in
    transit S c e w0 k ->
    (forall t, t \in ts -> rejected S e x t) -> uniq (unzip1 ts) ->
    (forall h, is_open S h -> h != e -> expected_percept b S h = percept_of x ->
       h \in unzip1 ts) ->
    pass e (Configuration S c p) (size w0 + 1 + tests_cost S x ts)
           (Configuration (add_vertex S e (percept_of x).1) (new_dart S) x).

(* line 1 *)
Definition initial := Configuration (initial_map (degree v0)) (0, 0) v0.

Inductive reached : nat -> nat -> configuration -> Prop :=
| ReachedStart : reached 0 0 initial
| ReachedPass n C e c C1 c' : reached n C c -> pass e c C1 c' -> reached n.+1 (C + C1) c'.

(* ---- Every pass keeps the map right ---- *)
Definition sound c := exists r,
  [/\ embedded (mapped c) r, known (mapped c) (here c), robot c = phi r (here c)
    & all_joined (mapped c)].

Lemma sound_initial : sound initial.
Proof.
exists [:: v0]; have I := embedded_initial v0; split=> //; first exact: (known_start I).
move=> [[|v] i] /andP[] //= _ l2; split; first by exists [::], (0, i).
by exists [::], (0, 0).
Qed.

(* lines 4-5: the robot arrives at the other end of e *)
Lemma arrival S r c p w0 k e : embedded S r -> known S c -> p = phi r c ->
  transit S c e w0 k -> motion k (walk w0 p) = alpha (phi r e).
Proof.
move=> I kc -> [_ _ [g R <-]].
by have [kg ->] := follow_phi I kc R; rewrite /motion (phi_turn I).
Qed.

Theorem pass_sound e c C c' : sound c -> pass e c C c' -> sound c'.
Proof.
move=> Ok P; case: P Ok => S d p w0 k ts => [h w f|] x Tr Rj Un => [oh he [Rh f0 _] V|H].
  case=> r [/= I kd pd Rc]; have xE := arrival I kd pd Tr; have [oe _ _] := Tr.
  have [kh _] := andP oh; have X := match_proves I kh Rh f0 V; have [kf E] := follow_phi I kh Rh.
  exists r; split=> /=.
  - by apply: (embedded_loop I) => //; rewrite -xE -/x X.
  - by [].
  - by rewrite X.
  - exact: (all_joined_loop I).
case=> r [/= I kd pd Rc]; have xE := arrival I kd pd Tr; rewrite -/x in xE; have [oe _ _] := Tr.
have [ke _] := andP oe.
have out f : known S f -> phi r f <> x.
  rewrite xE => kf E; have [opf fe] := other_end I oe kf (esym E).
  have sg : expected_percept b S f = percept_of x by rewrite (expected_percept_phi I kf) E xE.
  case/mapP: (H f opf fe sg) => -[h w] m /= fh; subst h.
  have [_ _ [g' [Rw g0 _]] NV] := Rj (f, w) m.
  by apply: NV; rewrite xE -E; exact: (truth_matches I kf Rw).
rewrite xE in out *; exists (rcons r (alpha (phi r e))); split=> /=; first exact: embedded_vertex.
- exact: known_new.
- by rewrite (phi_new I).
- by apply: (all_joined_vertex I) => //; exact: degree_gt0.
Qed.

Lemma reached_sound n C c : reached n C c -> sound c.
Proof. by elim=> [|m C0 e c1 C1 c2 _ O P]; [exact: sound_initial | exact: (pass_sound O P)]. Qed.

(* ---- No run is stuck ---- *)
Lemma list_choice (T U : eqType) (P : T -> U -> Prop) (s : seq T) :
  (forall x, x \in s -> exists y, P x y) ->
  exists ts : seq (T * U), unzip1 ts = s /\ forall t, t \in ts -> P t.1 t.2.
Proof.
elim: s => [|x s IH] H; first by exists [::].
have [y Py] := H x (mem_head _ _).
have [|ts [E Q]] := IH; first by move=> z zs; apply: H; rewrite inE zs orbT.
exists ((x, y) :: ts); split=> [|t]; first by rewrite /= E.
by rewrite inE => /orP[/eqP->|]; [exact: Py | exact: Q].
Qed.

Lemma home S r h : embedded S r -> all_joined S -> known S h -> exists w f, leads_home S h w f.
Proof. by move=> I Rc kh; apply: (simple_path I kh); case: (Rc h kh). Qed.

(* lines 3-4 can be done *)
Lemma transit_to S r d e : embedded S r -> all_joined S -> known S d -> is_open S e ->
  exists w k, transit S d e w k.
Proof.
move=> I Rc kd oe; have [ke _] := andP oe.
have [w [g [R g1 sw]]] : exists w g, [/\ follow S w d = Some g, g.1 = e.1 & size w < size (degrees S)].
  by apply: (simple_path I kd); exact: (joined_to I).
have [kg _] := follow_phi I kd R.
by exists w, (degree_in S g.1 - g.2 + e.2); split=> //; exists g => //; exact: turn_to.
Qed.

Theorem pass_progress e c : sound c -> is_open (mapped c) e -> exists C c', pass e c C c'.
Proof.
case: c => S d p [r [/= I kd pd Rc]] oe; have [w0 [k Tr]] := transit_to I Rc kd oe.
have X := arrival I kd pd Tr; set x := alpha (phi r e) in X.
case: (boolP (has (fun h => phi r h == x) (darts S))) => [/hasP[h]|/hasPn N].
  rewrite mem_darts => kh /eqP E; have [oh he] := other_end I oe kh (esym E).
  have [w [f Hf]] := home I Rc kh; have [Rw _ _] := Hf.
  do 2 eexists; apply: (@LoopPass e S d p w0 k [::] h w f Tr) => //.
  by rewrite X -E; exact: (truth_matches I kh Rw).
have [h|ts [tsE tsP]] := @list_choice _ _ (fun h w => rejected S e x (h, w))
    [seq h <- open_darts S | h != e].
  rewrite mem_filter mem_open_darts => /andP[he oh]; have [kh _] := andP oh.
  have [w [f Hf]] := home I Rc kh; have [Rw f0 _] := Hf; exists w; split=> //; first by exists f.
  move=> V; have E := match_proves I kh Rw f0 V.
  by have := N h; rewrite mem_darts E eqxx => /(_ kh).
do 2 eexists; apply: (@VertexPass e S d p w0 k ts Tr).
- by rewrite X => -[h w] /tsP.
- by rewrite tsE filter_uniq ?open_darts_uniq.
- by move=> h oh he _; rewrite tsE mem_filter he mem_open_darts.
Qed.

(* ---- Every pass explores one more edge ---- *)

(* the paper's |E_S| and its bound function t = |E_G| - |E_S| *)
Definition explored_edges c := (size (links (mapped c)))./2.
Definition variant c := edges W - explored_edges c.

Lemma pass_links e c C c' : pass e c C c' ->
  size (links (mapped c')) = (size (links (mapped c))).+2.
Proof. by case. Qed.

Lemma pass_size e c C c' : pass e c C c' ->
  size (degrees (mapped c')) <= (size (degrees (mapped c))).+1.
Proof. by case=> * //=; rewrite size_rcons. Qed.

Theorem pass_explores_one_edge e c C c' :
  pass e c C c' -> explored_edges c' = (explored_edges c).+1.
Proof. by move=> P; rewrite /explored_edges (pass_links P). Qed.

Lemma reached_links n C c : reached n C c -> size (links (mapped c)) = n.*2.
Proof. by elim=> //= m C0 e c1 C1 c2 _ E P; rewrite (pass_links P) E doubleS. Qed.

Lemma reached_size n C c : reached n C c -> size (degrees (mapped c)) <= n.+1.
Proof. by elim=> //= m C0 e c1 C1 c2 _ E P; exact: leq_trans (pass_size P) _. Qed.

Theorem pass_decreases_variant n C c e C1 c' :
  reached n C c -> pass e c C1 c' -> variant c = (variant c').+1.
Proof.
move=> R P; have [r [I _ _ _]] := reached_sound (ReachedPass R P).
have le : explored_edges c' <= edges W.
  by rewrite -(doubleK (edges W)) half_leq // edges_double; exact: (size_links I).
by rewrite /variant -subSn // (pass_explores_one_edge P) subSS.
Qed.
End Pass.

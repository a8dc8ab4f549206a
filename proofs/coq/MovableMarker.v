(* ---------------------------------------------------------------------------------------------
   One movable marker: Dudek, Jenkin, Milios, Wilkes 1991.                         Sections IV and VIII

   Each pass explores one open dart e of S.  The robot leaves by e, puts the marker down, comes back, and
   looks for it on a tour of S.  If no vertex of S shows it, the other end of e is a new vertex; the robot
   fetches the marker.  If one does, the robot carries the marker to the known end of e, comes back to that
   vertex, and leaves by its open darts one after the other, until it comes to the marker: that dart is the
   other end of e.

     one_edge_each        of two vertices, or of a vertex with itself, at most one edge.  Simple worlds are
                          such; with two loops at a vertex no explorer finds the maps of all worlds.
     leave S a d          the motion from dart a by dart d of the same vertex.
     go, seek, back_link  go to a vertex; look for the marker on a tour; find the dart that leads to it.
     movable_pass, movable pol   a pass, and the explorer; pol chooses the open darts.

     marker_behind_iff    a vertex of S shows the marker behind e if and only if e leads there: to an open
                          dart of that vertex that is not e.
     marker_behind_new    if no vertex of S does, e leads to none.
     back_link_iff        then, if the marker lies at the known end of e, exactly one dart of that vertex
                          besides e leads to it.
     seek_does, back_link_does   what these plans do in the world.
     movable_pass_does    a pass keeps S right, and explores one edge, within 5n + 2D operations.
     movable_correct      the explorer is right, within m (5n + 2D) operations, D the largest degree, and
                          the marker is in its hand in the end.
   --------------------------------------------------------------------------------------------- *)
From Coq Require Import Lia.
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Explorers PartialMaps Paths Pass Cost Correctness.
From Allworlds Require Import Routes Algorithm Queue Execution OnePass Refinement Carrying Tour.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition one_edge_each (G : combinatorial_map) := forall d e : G,
  at_same_vertex d e -> at_same_vertex (alpha d) (alpha e) -> d = e \/ d = alpha e.

Lemma simple_one_edge_each G : simple_world G -> one_edge_each G.
Proof. by move=> S d e c c'; left; exact: S. Qed.

(* ---- The explorer ---- *)
Definition leave S (a d : dart) := degree_in S a.1 - a.2 + d.2.

Fixpoint walk_by (w : seq nat) (f : dart) : plan dart :=
  if w is k :: w' then Do (Leave k) (fun _ => walk_by w' f) else Done f.
Definition go S a v := let way := route S a v in walk_by way.1 way.2.

Fixpoint seek S t a (o : view) : plan (bool * dart) :=
  if 0 < o.2 then Done (true, a)
  else if t is d :: t' then Do (Leave (leave S a d)) (seek S t' (far S d))
  else Done (false, a).

Fixpoint back_link S hs a : plan dart :=
  if hs is h :: hs' then
    Do (Leave (leave S a h)) (fun o =>
      if 0 < o.2 then Do PickUp (fun _ => Done h) else Do (Leave 0) (fun _ => back_link S hs' h))
  else Done a.

(* the other end of e, and the robot's dart: as a test of Algorithm 1 finds them *)
Definition other_end_new S e a : plan (option (dart * dart)) :=
  after (go S a e.1) (fun g =>
  Do (Leave (leave S g e)) (fun _ => Do PickUp (fun _ => Done None))).
Definition back_links S e v :=
  [seq h <- [seq (v, i) | i <- iota 0 (degree_in S v)] | (h != e) && is_open S h].
Definition other_end_at S e a : plan (option (dart * dart)) :=
  Do PickUp (fun _ => after (go S a e.1) (fun g =>
  Do PutDown (fun _ => after (go S g a.1) (fun b =>
  after (back_link S (back_links S e a.1) b) (fun h => Done (Some (h, e))))))).

Definition movable_pass pol k : plan knowledge :=
  let S := known_map k in
  let e := next_edge pol k in
  after (go S (at_dart k) e.1) (fun g =>
  Do (Leave (leave S g e)) (fun o => Do PutDown (fun _ => Do (Leave 0) (fun o' =>
  after (seek S (tour_from S e.1) e o') (fun seen =>
  after (if seen.1 then other_end_at S e seen.2 else other_end_new S e seen.2) (fun found =>
  Done (augment directional k e (o.1, None) (found, 0)))))))).

Definition movable pol : carrying_explorer numbered_map :=
  repeated (fun o => Done (knowledge_at_v0 o.1 0 0)) (movable_pass pol).

(* ---- Where the marker shows ---- *)
Section InWorld.
Variables (G : combinatorial_map) (v0 : G).
Local Notation embedded := (@embedded G v0).
Local Notation phi := (@phi G v0).
Local Notation n := (vertices G).

Section Embedded.
Variables (S : partial_map) (r : seq G).
Hypotheses (I : embedded S r) (J : all_joined S).

Lemma phi_same a d : a.1 = d.1 -> at_same_vertex (phi r a) (phi r d).
Proof.
move=> E; apply: connect_trans (phi_vertex v0 r d); rewrite -E -/(at_same_vertex _ _).
by rewrite at_same_vertex_sym; exact: phi_vertex.
Qed.

Theorem marker_behind_iff e a : is_open S e -> known S a ->
  at_same_vertex (alpha (phi r e)) (phi r a) <->
  exists h, [/\ alpha (phi r e) = phi r h, is_open S h, h != e & h.1 = a.1].
Proof.
move=> oe ka; split=> [c|[h [-> _ _ E]]]; last exact: phi_same.
have [la _] := knownP I ka.
have [|h kh E] := on_vertex I la (x := alpha (phi r e)).
  by apply: connect_trans (phi_vertex v0 r a) _; rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
have [oh he] := other_end I oe kh (esym E).
by exists h; split=> //; apply: (same_vertex I); rewrite // E.
Qed.

Lemma marker_behind_new e : (forall a, known S a -> ~~ at_same_vertex (alpha (phi r e)) (phi r a)) ->
  forall f, known S f -> phi r f <> alpha (phi r e).
Proof. by move=> N f /N c E; move: c; rewrite E /at_same_vertex connect0. Qed.

Theorem back_link_iff e h d : one_edge_each G -> is_open S e -> known S h ->
  alpha (phi r e) = phi r h -> known S d -> d.1 = h.1 -> d != e ->
  at_same_vertex (phi r e) (alpha (phi r d)) <-> d = h.
Proof.
move=> one /andP[ke _] kh E kd dh de; split=> [c|->]; last by rewrite -E alphaK /at_same_vertex connect0.
have [||F|F] := one (phi r d) (phi r h); first exact: phi_same.
- by rewrite -E alphaK at_same_vertex_sym.
- exact: (phi_inj I kd kh F).
by case/eqP: de; apply: (phi_inj I) => //; rewrite F -E alphaK.
Qed.

(* ---- The plans in the world ---- *)
Lemma leaves a d m : known S a -> known S d -> a.1 = d.1 ->
  result 1 (Leave (leave S a d)) (phi r a, m) = Some (alpha (phi r d), m).
Proof. by move=> ka kd E; rewrite /= /motion -(phi_turn I) // turn_to. Qed.

Lemma seen_here (d x : G) : (0 < (view_of (d, [:: x])).2) = at_same_vertex x d.
Proof. by rewrite /= addn0 lt0b. Qed.

Lemma picked_up (d x : G) : at_same_vertex x d -> result 1 PickUp (d, [:: x]) = Some (d, [::]).
Proof. by move=> c; rewrite /= /lies_here c. Qed.

Lemma go_does a e m : known S a -> known S e -> exists g,
  [/\ does 1 (go S a e.1) (phi r a, m) g (phi r g, m) n.-1, known S g & g.1 = e.1].
Proof.
move=> ka ke; have [F E lt] := routeP ka (partner_known I) (joined_to I J ka ke).
have [kg W] := follow_phi I ka F; exists (route S a e.1).2; split=> //.
have le : size (route S a e.1).1 <= n.-1.
  by rewrite -ltnS prednK ?(vertices_gt0 v0) // (leq_trans lt) // (size_vertices I).
apply: does_more le _; rewrite -W /go; move: (route _ _ _).1 (route _ _ _).2 (phi r a) => w' f'.
by elim: w' => [|k w' IH] d /=; [exact: does_done | apply: does_do].
Qed.

Lemma seek_does x t c : let a := far S c in known S a ->
  path (leads_on S) c t && all (explored S) t -> exists b, let seen := at_same_vertex x (phi r b) in
  [/\ known S b, does 1 (seek S t a (view_of (phi r a, [:: x]))) (phi r a, [:: x]) (seen, b)
        (phi r b, [:: x]) (size t)
    & ~~ seen -> forall d, d \in a :: t -> ~~ at_same_vertex x (phi r d)].
Proof.
elim: t c => [|d t IH] c a ka; rewrite [seek _ _ _ _]/= seen_here.
  move=> _; exists a; split=> //; last by move=> N d; rewrite mem_seq1 => /eqP->.
  by case: ifP => _; exact: does_done.
case/andP=> /andP[/eqP dE L] /andP[/partner_total[f P] T].
have [kd kf E _] := embedded_links I (partnerP P); have fE : far S d = f by rewrite /far P.
have := IH d; rewrite fE => /(_ kf (introT andP (conj L T)))[b [kb D N]].
case: ifP => c'; first by exists a; rewrite c'; split=> //; exact: does_done.
exists b; split=> // [|/N out d']; first by apply: does_do; [exact: leaves | rewrite E].
have dc : at_same_vertex x (phi r d) = false.
  by apply/negP=> cd; case/negP: (negbT c'); apply: connect_trans cd _; exact: phi_same.
rewrite inE => /orP[/eqP->|]; first by rewrite c'.
by rewrite inE => /orP[/eqP->|m]; [rewrite dc | rewrite out // inE m orbT].
Qed.

Lemma back_link_does e h y hs a : one_edge_each G -> is_open S e -> known S h ->
  alpha (phi r e) = phi r h -> at_same_vertex y (phi r e) ->
  known S a -> a.1 = h.1 -> (forall d, d \in hs -> [/\ known S d, d.1 = h.1 & d != e]) -> h \in hs ->
  does 1 (back_link S hs a) (phi r a, [:: y]) h (phi r e, [::]) (2 * size hs).
Proof.
move=> one oe kh E cy; elim: hs a => // d hs IH a ka aE H mh.
have [kd dE de] := H d (mem_head _ _); rewrite mulnS; apply: does_do; first by apply: leaves; rewrite ?aE.
have B := back_link_iff one oe kh E kd dE de.
have -> : (0 < (view_of (alpha (phi r d), [:: y])).2) = (d == h).
  rewrite seen_here; apply/idP/eqP=> [c|/B]; last exact: connect_trans.
  by apply/B; apply: connect_trans c; rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
case: eqP mh => [-> _|ne].
  by apply: does_do; [apply: picked_up; rewrite -E alphaK | rewrite -E alphaK; exact: does_done].
rewrite inE => /orP[/eqP hd|mh]; first by rewrite hd in ne.
apply: (@does_do _ _ _ _ _ _ (phi r d, [:: y])); first by rewrite /= /motion /= alphaK.
by apply: IH => // d' m'; apply: H; rewrite inE m' orbT.
Qed.
End Embedded.

(* ---- A pass ---- *)
Hypothesis one : one_edge_each G.
Local Notation W := (@LighthouseWorld G v0 v0 (connect0 _ v0)).
Definition largest_degree := \max_(d : G) degree d.
Definition movable_pass_bound := 5 * n + 2 * largest_degree.

Definition ready k (s : state G) :=
  let c := @Configuration W (known_map k) (at_dart k) s.1 in
  [/\ s.2 = [::], grown (known_map k), due_turn k = 0, sound c & @knows W k c s.1].

Lemma ready_first : ready (knowledge_at_v0 (degree v0) 0 0) (v0, [::]).
Proof.
split=> //=; [by case | exact: (sound_initial W) | split=> //=].
  by rewrite /first_bearing findex0.
exact: queue_initial.
Qed.

Section Pass.
Variables (k : knowledge) (d : G) (r : seq G) (e b : dart).
Local Notation S := (known_map k).
Local Notation x := (alpha (phi r e)).
Hypotheses (R : ready k (d, [::])) (I : embedded S r) (J : all_joined S).
Hypotheses (oe : is_open S e) (kb : known S b).
Local Notation augmented := (augment directional k e (degree x, None)).

Lemma other_end_at_does : at_same_vertex x (phi r b) ->
  exists found s, [/\ does 1 (other_end_at S e b) (phi r b, [:: x]) found s
    (2 * n.-1 + 2 + 2 * largest_degree) & ready (augmented (found, 0)) s].
Proof.
move=> c; have [ke _] := andP oe; have [lb _] := andP kb.
have [h [E oh he hb]] := (marker_behind_iff I oe kb).1 c; have [kh _] := andP oh.
have [_ Gr _ _ [kb0 _ _ Q _]] := R; set hs := back_links S e b.1.
have H d' : d' \in hs -> [/\ known S d', d'.1 = h.1 & d' != e].
  by rewrite mem_filter hb => /andP[/andP[de /andP[]] kd' _ /mapP[i _ E']]; split; rewrite // E'.
have mh : h \in hs.
  rewrite mem_filter oh he; apply/mapP; exists h.2; last by rewrite -hb -surjective_pairing.
  by case/andP: kh; rewrite mem_iota hb.
have [g [D1 kg g1]] := go_does I J [::] kb ke.
have [g' [D2 kg' g1']] := go_does I J [:: phi r g] kg kb.
have D3 := back_link_does I one oe kh E (phi_same r g1) kg' (etrans g1' (esym hb)) H mh.
have le : size hs <= largest_degree.
  rewrite /hs /back_links size_filter (leq_trans (count_size _ _)) // size_map size_iota.
  by rewrite (degree_phi I) -?(size_degrees I) //; exact: leq_bigmax.
exists (Some (h, e)), (phi r e, [::]); split.
  apply: (@does_more _ _ _ _ _ _ _ (1 + (n.-1 + (1 + (n.-1 + (2 * size hs + 0)))))).
    by move: le => /leP le; apply/leP; rewrite -!(plusE, multE); lia.
  apply: does_do; first exact: picked_up.
  apply: (does_after D1); apply: does_do; first by [].
  apply: (does_after D2); apply: (does_after D3); exact: does_done.
split=> //=; first exact: grown_loop.
  by exists r; split=> //=; [exact: (embedded_loop I oe oh he E) | exact: (all_joined_loop I)].
split=> //=; exact: queue_loop.
Qed.

Lemma other_end_new_does : (forall f, known S f -> phi r f <> x) ->
  exists found s, [/\ does 1 (other_end_new S e b) (phi r b, [:: x]) found s
    (2 * n.-1 + 2 + 2 * largest_degree) & ready (augmented (found, 0)) s].
Proof.
move=> out; have [ke _] := andP oe; have [_ Gr _ _ [kb0 _ _ Q _]] := R.
have [g [D1 kg g1]] := go_does I J [:: x] kb ke.
exists None, (x, [::]); split.
  apply: does_more (_ : n.-1 + 2 <= _) _; first by rewrite -addnA leq_add ?leq_pmull ?leq_addr.
  apply: (does_after D1); apply: does_do; first exact: leaves.
  by apply: does_do; [exact/picked_up/connect0 | exact: does_done].
split=> //=; first exact: (grown_vertex I oe Gr).
  exists (rcons r x); split=> //=; [exact: (embedded_vertex I oe out) | exact: known_new | |].
    by rewrite (phi_new I).
  by apply: (all_joined_vertex I) => //; exact: degree_gt0.
split=> //=; apply: queue_vertex => // y /exploredP[f m].
by have [? _ _ _] := embedded_links I m.
Qed.
End Pass.

Theorem movable_pass_does pol k s : ready k s -> unexplored k != [::] -> exists k' s',
  [/\ does 1 (movable_pass pol k) s k' s' movable_pass_bound, ready k' s' &
      unexplored_edges G k' < unexplored_edges G k].
Proof.
case: s => d m R ne; have [/= mE Gr _ [r [I kh ph J]] [_ _ _ [_ mU] _]] := R.
rewrite {m}mE in R *; rewrite /= in I kh ph J; set S := known_map k in Gr I kh J mU *.
set e := next_edge pol k; have oe : is_open S e.
  rewrite -mU /e /next_edge; case: ifP => // _.
  by case: (unexplored k) ne => // *; exact: mem_head.
have [ke _] := andP oe; set x := alpha (phi r e).
have [g [D1 kg g1]] := go_does I J [::] kh ke.
have kf : known S (far S e) by rewrite far_open.
have := seek_does I x kf (tour_walks I Gr oe); rewrite far_open // => -[b [kb D2 N]].
set seen := at_same_vertex x (phi r b) in D2 N.
have [found [s' [D3 R']]] : exists found s',
    [/\ does 1 (if seen then other_end_at S e b else other_end_new S e b) (phi r b, [:: x]) found s'
          (2 * n.-1 + 2 + 2 * largest_degree)
      & ready (augment directional k e (degree x, None) (found, 0)) s'].
  case c: seen N => N; first exact: (other_end_at_does R).
  apply: (other_end_new_does R I J oe kb); apply: marker_behind_new => a ka; have [la _] := andP ka.
  have [d' m' dE] := tour_visits Gr ke la; have := N isT d' m'; apply: contra => ca.
  apply: connect_trans ca _; exact: phi_same.
exists (augment directional k e (degree x, None) (found, 0)), s'; split=> //; last first.
  have [_ _ _ [r' [I' _ _ _]] _] := R'; have := size_links I'.
  rewrite -edges_double /unexplored_edges; case: found {D3 R' I'} => [[h f]|] /= /half_leq;
    rewrite doubleK => le; exact: ltn_sub2l.
have le := size_vertices I; have n0 : 0 < n by exact: vertices_gt0 v0.
apply: (@does_more _ _ _ _ _ _ _ (n.-1 + (3 + (2 * (size (degrees S)).-1 +
    (2 * n.-1 + 2 + 2 * largest_degree + 0))))).
  rewrite /movable_pass_bound; move: le n0 => /leP le /leP n0.
  by apply/leP; rewrite -!(plusE, multE); lia.
rewrite ph; apply: (does_after D1); apply: does_do; first exact: leaves.
apply: does_do; first by [].
apply: (@does_do _ _ _ _ _ _ (phi r e, [:: x])); first by rewrite /= /motion /= alphaK.
rewrite size_rot size_tour in D2; apply: (does_after D2); apply: (does_after D3); exact: does_done.
Qed.

Lemma pass_acts pol k : exists a f, movable_pass pol k = Do a f.
Proof. by rewrite /movable_pass /go; case: (route _ _ _).1 => [|j w] /=; do 2 eexists. Qed.

Theorem movable_correct pol budget : edges G * movable_pass_bound <= budget -> exists t answer z,
  [/\ carrying_episode 1 (movable pol) v0 budget = (t, Some answer, (z, [::])),
      size t <= edges G * movable_pass_bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; have [t [k [[z m] [R C [/= mE _ _ Ok K] U]]]] :=
  repeated_ends (pass_acts pol) (@movable_pass_does pol) ready_first.
rewrite /unexplored_edges subn0 in C; have [_ V J] := estimate_right Ok K U.
exists t, (estimate k), z; split=> //.
by rewrite episode_perform -(subnKC (leq_trans C le)) R mE.
Qed.
End InWorld.

(* ---------------------------------------------------------------------------------------------
   A pass of the program is a pass of the relation, step for step.          Sections IV, V and VI

   For any lighthouse L, once it is known in what its percepts and `confirm` amount to in the world, and
   under every policy:

     tests                what p does when it tests hypotheses one after the other.
     knows k c d          k says what is so in configuration c, the robot being at d.
     one_pass_makes       a pass of the program is a `pass_by` (Lighthouses.v).
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts Explorers PartialMaps HypothesisTests Paths Pass.
From Allworlds Require Import Lighthouses Routes Algorithm Queue Execution.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section InWorld.
Variables (W : lighthouse_world) (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Variable senses : W -> O.
Local Notation v0 := (@start W).
Local Notation b := (first_bearing W).
Local Notation phi := (@phi W v0).
Local Notation program := (program O).
Local Notation makes := (makes senses).
Local Notation foretells := (foretells L).

Variables (confirms : partial_map -> dart -> W -> bool) (confirm_cost : nat).
Hypothesis reads_senses : forall d, reads L (senses d) = foretells (percept_of d).
Hypothesis degree_foretold : forall o, (foretells o).1 = o.1.
Hypothesis confirm_makes : forall k f y c d, bearing0 k = b -> f.1 = 0 ->
  degree y = degree_in (known_map k) f.1 -> due c d y -> exists c' z,
  makes (confirm L k f c) d (confirms (known_map k) f y, c') z confirm_cost /\ due c' z y.

Local Notation looks := (looks foretells).
Local Notation matches := (matches foretells confirms).
Local Notation failed_cost := (failed_cost foretells confirm_cost).
Local Notation refuted := (refuted foretells confirms).
Local Notation pass_by := (pass_by foretells confirms confirm_cost).

Lemma check_path_makes w (P : seq percept) done c d y x :
  due c d y -> size P = (size w).+1 -> trail done y x ->
  exists done' c' z y',
    let sensed := map foretells (percepts_along w y) in let P' := map foretells P in
    let j := find (fun q => q.1 != q.2) (zip sensed P') in
    if sensed == P' then
      [/\ makes (check_path L w P' done c (senses y)) d (true, done', c') z (size w),
          due c' z (walk w y), trail done' (walk w y) x & size done' = size done + size w]
    else [/\ makes (check_path L w P' done c (senses y)) d (false, done', c') z j,
             due c' z y', trail done' y' x & size done' = size done + j].
Proof.
elim: w P done c d y => [|k w IH] [|e0 P] done c d y du //= [sz] T.
  case: P sz => // _; exists done, c, d, y; rewrite reads_senses eqseq_cons eqxx andbT.
  by case: (_ =P foretells e0) => E /=; rewrite ?addn0; split=> //; exact: makes_return.
rewrite reads_senses eqseq_cons; case: (_ =P foretells e0) => E /=; last first.
  by exists done, c, d, y; split; rewrite ?addn0 //; exact: makes_return.
have T' : trail ((k, (foretells (percept_of y)).1) :: done) (motion k y) x.
  by exists y; rewrite degree_foretold.
have [done' [c' [z [y' H]]]] := IH P _ 0 (motion k y) (motion k y) (erefl _) sz T'.
exists done', c', z, y'; move: H => /=; case: ifP => _; case=> A C D F.
all: by split=> //; [apply: makes_go; rewrite (motion_due k du) | rewrite F addSnnS].
Qed.

(* lines 7-17: some of the hypotheses hs are refuted, one after the other; then one matches, or none is
   left; p, run from dart d, does so *)
Definition tests S e (x : W) (home : dart -> seq nat * dart) hs (p : program _) d :=
  exists ts, let cost := \sum_(t <- ts) failed_cost S x t in
  [/\ forall t, t \in ts -> refuted S e x t, {subset unzip1 ts <= hs}, uniq (unzip1 ts) &
    (unzip1 ts = hs /\ exists c' z, makes p d (None, c') z cost /\ due c' z x)
    \/ exists h c' z, let way := home h in
      [/\ h \in hs, uniq (h :: unzip1 ts), matches S x (h, way.1) way.2,
          makes p d (Some (h, way.2), c') z (cost + (size way.1 + confirm_cost))
        & due c' z (walk way.1 x)]].

Lemma test_all_makes k r e (x : W) hs c d : bearing0 k = b -> embedded v0 (known_map k) r ->
  (forall h, h \in hs -> [/\ is_open (known_map k) h, h != e &
     leads_home (known_map k) h (way_home pol k h).1 (way_home pol k h).2]) ->
  uniq hs -> due c d x ->
  tests (known_map k) e x (way_home pol k) hs (test_all L pol k (senses x) hs c) d.
Proof.
move=> kb I; set S := known_map k in I *; elim: hs c d => [|h hs IH] c d H U du.
  exists [::]; split=> //; left; split=> //; exists c, d; rewrite big_nil.
  by split=> //; exact: makes_return.
have [oh he Lh] := H h (mem_head _ _); have [R f0 sw] := Lh; have /andP[hU U'] := U.
have [kh _] := andP oh.
set w := (way_home pol k h).1 in Lh R sw; set f := (way_home pol k h).2 in Lh R f0.
have [done [c1 [z1 [y CK]]]] := check_path_makes du (size_expected W R) (erefl : trail [::] x x).
have go_on p c2 z2 : ~~ matches S x (h, w) f -> due c2 z2 x ->
    (forall a z n, makes (test_all L pol k (senses x) hs c2) z2 a z n ->
       makes p d a z (failed_cost S x (h, w) + n)) ->
    tests S e x (way_home pol k) (h :: hs) p d.
  move=> N du2 Mk; have [|ts [Rj Sb Ut HH]] := IH c2 z2 _ U' du2.
    by move=> h' m; apply: H; rewrite inE m orbT.
  exists ((h, w) :: ts); rewrite big_cons; split=> /=.
  - by move=> t; rewrite inE => /orP[/eqP->|]; [split=> //; exists f | exact: Rj].
  - by move=> q; rewrite !inE => /orP[->//|/Sb->]; rewrite orbT.
  - by rewrite Ut andbT; apply: contra hU; exact: Sb.
  case: HH => [[tsE [c3 [z3 [A3 B3]]]]|[g [c3 [z3 [mg Ug Vg A3 B3]]]]]; [left|right].
    by rewrite tsE; split=> //; exists c3, z3; split=> //; exact: Mk A3.
  exists g, c3, z3; rewrite -addnA; split=> //; [by rewrite inE mg orbT | | exact: Mk].
  case/andP: Ug => gt _; rewrite inE negb_or gt Ut !andbT; apply/andP; split.
    by apply/eqP=> gh; move: hU; rewrite -gh mg.
  by apply: contra hU; exact: Sb.
rewrite /= kb -/w -/f -/S.
move: CK => /=; case: ifP => [V [A du1 T F]|V [A du1 T F]]; last first.
  have [c2 [z2 [A2 B2]]] := go_back_makes senses du1 T; rewrite /= add0n in F.
  apply: (go_on _ c2 z2) => [||a z q Q] //.
    by rewrite /Lighthouses.matches /Lighthouses.looks /foretold V.
  rewrite /Lighthouses.failed_cost /Lighthouses.looks /foretold /= V mul2n -addnn -addnA.
  by rewrite F in A2; apply: (makes_bind A); exact: (makes_bind A2 Q).
have Lk : looks S x (h, w) by [].
have [kf _] := follow_phi I kh R; have [lf _] := knownP I kf.
have D : degree (walk w x) = degree_in S f.1.
  have := congr1 fst (looks_last I kh R Lk); rewrite !degree_foretold /= => ->.
  by rewrite (degree_same (phi_vertex v0 r f)) (degree_phi I lf).
have [c2 [z2 [A2 du2]]] := confirm_makes kb f0 D du1.
case C: (confirms S f (walk w x)) in A2.
  exists [::]; split=> //; right; exists h, c2, z2; rewrite -/w -/f -/S; split=> //.
  - exact: mem_head.
  - by rewrite /Lighthouses.matches Lk.
  rewrite big_nil add0n; apply: (makes_bind A).
  rewrite -[confirm_cost]addn0; apply: (makes_bind A2); exact: makes_return.
have [c3 [z3 [A3 du3]]] := go_back_makes senses du2 T; rewrite /= add0n in F.
apply: (go_on _ c3 z3) => [||a z q Q] //; first by rewrite /Lighthouses.matches Lk C.
rewrite /Lighthouses.failed_cost Lk mul2n -addnn -!addnA; apply: (makes_bind A).
rewrite addnCA; apply: (makes_bind A2); rewrite F in A3; exact: (makes_bind A3 Q).
Qed.

(* ---- One pass of the program is a pass of the relation ---- *)
Definition knows k (c : configuration W) (d : W) :=
  [/\ bearing0 k = b, mapped c = known_map k, here c = at_dart k,
      queue_of (known_map k) (unexplored k) & due (due_turn k) d (robot c)].

Theorem one_pass_makes k c d : sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes (one_pass L pol k) d k' z n, pass_by (next_edge pol k) c n c'
    & knows k' c' z].
Proof.
case: c => S0 h0 p Ok [/= kb ES Eh Q du] ne; subst S0 h0.
set S := known_map k in Q Ok *; set h0 := at_dart k in Ok *; set e := next_edge pol k.
have [Un mU] := Q; have [r [/= I kh ph Rc]] := Ok.
have oe : is_open S e.
  rewrite -mU /e /next_edge; case: ifP => // _.
  by case: (unexplored k) ne => // *; exact: mem_head.
have [ke _] := andP oe.
have [R g1 sw0] : let way := way_to pol k e in
    [/\ follow S way.1 h0 = Some way.2, way.2.1 = e.1 & size way.1 < size (degrees S)].
  by apply: (route_or_elseP kh (partner_known I)); exact: (joined_to I).
rewrite /one_pass -/S -/e; set w0 := (way_to pol k e).1 in R sw0 *.
set g := (way_to pol k e).2 in R g1 *.
have [kg _] := follow_phi I kh R; have T := turn_to kg ke g1; set j := (_ + _) in T *.
have Tr : transit S h0 e w0 j by split=> //; exists g.
have Wk := walk_to_makes senses w0 j du; set x := motion j (walk w0 p) in Wk.
set hs := hypotheses L pol k e (senses x).
pose H := [seq h <- unexplored k | (h != e) &&
  (foretells (expected_percept b S h) == reads L (senses x))].
have pH : perm_eq hs H by rewrite /hs /hypotheses -/S kb -/H; case: ifP.
have mH h : (h \in hs) = [&& h != e, foretells (expected_percept b S h) == foretells (percept_of x)
    & is_open S h].
  by rewrite (perm_mem pH) mem_filter mU -reads_senses andbA.
have Uh : uniq hs by rewrite (perm_uniq pH) filter_uniq.
have Hh h : h \in hs -> [/\ is_open S h,
  h != e & leads_home S h (way_home pol k h).1 (way_home pol k h).2].
  rewrite mH => /and3P[he _ oh]; have [kh' _] := andP oh.
  by have [Ra Rb Rd] := route_or_elseP kh' (partner_known I) (choose_home pol k h) (proj1 (Rc h kh')).
have [ts [Rj Sb Ut HH]] := test_all_makes kb I Hh Uh (erefl (iter 0 sigma x)).
case: HH => [[E [c' [z [A C]]]]|[h [c' [z [mh Uh' V A C]]]]].
  exists (augment L k e (senses x) (None, c')), z; do 2 eexists; split.
  - apply: (makes_bind Wk); apply: (makes_bind A); exact: makes_return.
  - rewrite addn0 -[_.+1]addn1.
    apply: (@VertexPassBy _ _ _ _ _ e S h0 p w0 j ts Tr Rj Ut) => h oh he sg.
    by rewrite E mH he sg eqxx oh.
  rewrite /augment reads_senses degree_foretold.
  split=> //=; apply: queue_vertex => // y /exploredP[f m].
  by have [? _ _ _] := embedded_links I m.
have [oh he Lh] := Hh h mh.
exists (augment L k e (senses x) (Some (h, (way_home pol k h).2), c')), z; do 2 eexists; split.
- apply: (makes_bind Wk); apply: (makes_bind A); exact: makes_return.
- rewrite addn0 addnA -[_.+1]addn1.
  exact: (@LoopPassBy _ _ _ _ _ e S h0 p w0 j ts h _ _ Tr Rj Uh' oh he Lh V).
by split=> //=; exact: queue_loop.
Qed.

End InWorld.

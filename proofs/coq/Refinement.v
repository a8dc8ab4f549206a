(* ---------------------------------------------------------------------------------------------
   The program is an instance of the relation: every pass of one_pass is a `pass`, step for step, under
   every policy and in every world.                                          Sections IV, V and VI

     queue_of S U         the list U holds the open darts of S, each once.
     exec p d             program p, run in the world from dart d: its result, the robot's dart, the
                          transcript.
     makes p d x z n      run from dart d, program p gives x, at dart z, after n traversals.
     due c d x            a robot at d that turns by c is as if it had come in by x.
     trail done y x       the motions in done lead from x to y.

   For any lighthouse L, once it is known in what its percepts and `confirm` amount to in the world:
     tests                what p does when it tests hypotheses one after the other.
     knows k c d          k says what is so in configuration c, the robot being at d.
     one_pass_makes       a pass of the program is a `pass_by` (Lighthouses.v).
     episode_machine      the explorer, which remembers all percepts, is the machine, which does
                          not.
     explorer_by_correct  if each test decides its hypothesis and set_out finds the bearing, the
                          explorer is right, within any budget that covers set_out and bound_by.
     estimate_right       when U is empty the estimate is the world seen from the robot's true
                          dart.

   For the directional lighthouse:
     one_pass_is_pass     the refinement.
     algorithm1_correct   in every world with a directional lighthouse, under every policy, with
                          any budget of at least (1)+(2) traversals: it stops after at most
                          (1)+(2), and is right.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers Indistinguishable PartialMaps.
From Allworlds Require Import HypothesisTests Paths Pass Cost Correctness Lighthouses Routes Algorithm.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- U as a queue ---- *)
Definition queue_of S (U : seq dart) := uniq U /\ forall e, (e \in U) = is_open S e.

Lemma queue_initial k : queue_of (initial_map k) [seq (0, i) | i <- iota 0 k].
Proof.
split=> [|[v i]]; first by rewrite map_inj_uniq ?iota_uniq // => i j [].
rewrite /is_open andbT; apply/mapP/andP=> [[j]|[]]; first by rewrite mem_iota => /= lj [-> ->].
by case: v => //= _ li; exists i; rewrite ?mem_iota.
Qed.

Lemma queue_loop S U e h : queue_of S U ->
  queue_of (add_loop S e h) [seq x <- U | (x != e) && (x != h)].
Proof.
case=> Un mU; split=> [|x]; first exact: filter_uniq.
rewrite mem_filter mU /is_open /explored /= !inE !negb_or /known /=.
by rewrite -!andbA; do !case: (_ == _) => //=; rewrite ?andbF.
Qed.

Lemma queue_vertex S U e k : queue_of S U -> known S e -> (forall x, explored S x -> known S x) ->
  queue_of (add_vertex S e k)
    ([seq x <- U | x != e] ++ [seq (size (degrees S), i) | i <- iota 1 k.-1]).
Proof.
case=> Un mU ke lk; set n := size (degrees S).
have out i : ~~ known S (n, i) by rewrite /known ltnn.
split=> [|[v i]].
  rewrite cat_uniq filter_uniq // map_inj_uniq ?iota_uniq ?andbT /= => [|i j [] //].
  apply/hasPn=> x /mapP[i _ ->]; rewrite /= mem_filter mU /is_open.
  by rewrite (negbTE (out i)) !andbF.
rewrite mem_cat mem_filter mU /is_open /explored /= !inE !negb_or -/(explored S (v, i)).
case: (ltngtP v n) => [lv|gv|->].
- have nn j : ((v, i) == (n, j) :> dart) = false by rewrite xpair_eqE (ltn_eqF lv).
  have -> : (v, i) \in [seq (n, j) | j <- iota 1 k.-1] = false.
    by apply/mapP=> -[j _ /eqP]; rewrite nn.
  rewrite nn /known /degree_in /= size_rcons nth_rcons -/n lv (ltnW lv : v < n.+1) orbF /=.
  by rewrite andbCA.
- have -> : known (add_vertex S e k) (v, i) = false by rewrite /known /= size_rcons ltnS leqNgt gv.
  rewrite /known /= [v < n]ltnNge (ltnW gv) andbF /=; apply/mapP=> -[j _ [E]].
  by rewrite E ltnn in gv.
rewrite (negbTE (out i)) andbF /= /known /degree_in /= size_rcons nth_rcons -/n ltnn eqxx ltnSn /=.
have -> : (n, i) == e = false by apply/eqP=> E; move: (out i); rewrite E ke.
have -> : explored S (n, i) = false by apply/negP=> /lk; rewrite (negbTE (out i)).
rewrite xpair_eqE eqxx /= andbT.
apply/mapP/andP=> [[j]|[lk' i0]].
  rewrite mem_iota => /andP[j0 jk] [->]; rewrite -lt0n; split=> //.
  by case: k jk => [|k] //; rewrite ltnS leqNgt j0.
by exists i; rewrite // mem_iota lt0n i0; case: k lk'.
Qed.

(* ---- The explorer that remembers everything is the machine that remembers its program only ---- *)
Section Remembering.
Variables (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Variables (M : rooted_map) (senses : carrier M -> O).
Local Notation machine := (machine L pol (motion_in M) senses).

Lemma explore_machine budget o seen d :
  explore (explorer_by L pol) M senses budget (o :: seen) d
  = machine budget (foldl (sense L pol) (set_out L o) seen) d.
Proof.
elim: budget seen d => [|n IH] seen d /=; rewrite /act; case E: (next L pol _) => [e|[k f]] //.
rewrite IH.
have -> : foldl (sense L pol) (set_out L o) (rcons seen (senses (motion_in M k d)))
    = f (senses (motion_in M k d)).
  by rewrite -cats1 foldl_cat /= /sense E.
by [].
Qed.

Theorem episode_machine budget :
  episode (explorer_by L pol) M senses budget
  = machine budget (set_out L (senses (root M))) (root M).
Proof. exact: explore_machine. Qed.
End Remembering.

(* ---- A program in a world ---- *)
Section Makes.
Variables (G : combinatorial_map) (O : Type) (senses : G -> O).
Local Notation program := (program O).

Fixpoint exec A (p : program A) (d : G) : A * G * seq (nat * O) :=
  match p with
  | Return x => (x, d, [::])
  | Go k f =>
      let: (x, z, t) := exec (f (senses (motion k d))) (motion k d) in
      (x, z, (k, senses (motion k d)) :: t)
  end.
Definition makes A (p : program A) d x z n := exists t, exec p d = (x, z, t) /\ size t = n.

Lemma makes_return A (x : A) d : makes (Return x) d x d 0.
Proof. by exists [::]. Qed.

Lemma makes_go A k (f : O -> program A) d x z n :
  makes (f (senses (motion k d))) (motion k d) x z n -> makes (Go k f) d x z n.+1.
Proof. by case=> t [E <-]; exists ((k, senses (motion k d)) :: t); rewrite /= E. Qed.

Lemma makes_bind A B (p : program A) (f : A -> program B) d x z n y z' n' :
  makes p d x z n -> makes (f x) z y z' n' -> makes (bind p f) d y z' (n + n').
Proof.
case=> t [E <-] F; elim: p d t E => [x'|k g IH] d t /=; first by case=> -> -> <-.
case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1; rewrite addSn; apply: makes_go.
exact: (IH _ _ _ E).
Qed.

Definition due c (d x : G) := iter c sigma d = x.

Lemma motion_due c d x k : due c d x -> motion (c + k) d = motion k x.
Proof. by move=> <-; rewrite /motion addnC iterD. Qed.

Lemma walk_to_makes w k c d x : due c d x ->
  makes (walk_to O w k c) d (senses (motion k (walk w x))) (motion k (walk w x)) (size w).+1.
Proof.
elim: w c d x => [|j w IH] c d x du /=; apply: makes_go; rewrite (motion_due _ du).
  exact: makes_return.
exact: IH.
Qed.

Fixpoint trail (done : seq (nat * nat)) (y x : G) :=
  if done is q :: done' then
    exists z, [/\ y = motion q.1 z, q.2 = degree z & trail done' z x]
  else y = x.

(* line 15: the robot retraces, coming back to v_u and resuming its orientation *)
Lemma go_back_makes done c d y x : due c d y -> trail done y x ->
  exists c' z, makes (go_back O done c) d c' z (size done) /\ due c' z x.
Proof.
elim: done c d y => [|[k n] done IH] c d y du /=.
  by move=> <-; exists c, d; split=> //; exact: makes_return.
case=> z [Y N T]; have E : motion c d = iter k sigma z.
  by rewrite -[c]addn0 (motion_due 0 du) Y /motion /= alphaK.
have [|c' [z' [A B]]] := IH (opposite n k) (motion c d) z _ T.
  by rewrite E N; exact: opposite_turn.
by exists c', z'; split=> //; exact: makes_go.
Qed.
End Makes.

(* ---- A pass of the program, with any lighthouse ---- *)
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
have Hl x y : partner S x = Some y -> known S y.
  by move=> P; have [_ ? _ _] := embedded_links I (partnerP P).
have [R g1 sw0] : let way := way_to pol k e in
    [/\ follow S way.1 h0 = Some way.2, way.2.1 = e.1 & size way.1 < size (degrees S)].
  apply: route_or_elseP => //; have [[w [f [Rw f0]]] _] := Rc h0 kh; have [_ A] := Rc e ke.
  by have [kf _] := follow_phi I kh Rw; exact: (joined_trans Rw (joined_turn A kf f0)).
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
  by have [Ra Rb Rd] := route_or_elseP kh' Hl (choose_home pol k h) (proj1 (Rc h kh')).
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

(* ---- The whole run ---- *)
Local Notation machine := (machine L pol motion senses).

Lemma machine_next fuel p q d : next L pol p = next L pol q -> machine fuel p d = machine fuel q d.
Proof. by case: fuel => [|fuel] /= ->. Qed.

Lemma next_pass k : unexplored k != [::] -> next L pol (Return k) = next L pol (one_pass L pol k).
Proof.
rewrite /=; case E: (unexplored k) => // _.
by rewrite /one_pass; case: (way_to pol k (next_edge pol k)).1.
Qed.

Lemma machine_exec p d s z t fuel t' e z' :
  exec senses p d = (s, z, t) -> machine fuel (Return s) z = (t', Some e, z') ->
  machine (size t + fuel) p d = (t ++ t', Some e, z').
Proof.
move=> E F; elim: p d t E => [x|k g IH] d t; first by case=> -> -> <-.
rewrite [exec _ _ _]/=; case E: (exec _ _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1.
by rewrite [size _]/= addSn [Algorithm.machine _ _ _ _ _ _ _]/= (IH _ _ _ E).
Qed.

Hypothesis decides : forall S r h w f x, embedded v0 S r -> known S h -> follow S w h = Some f ->
  f.1 = 0 -> matches S x (h, w) f <-> x = phi r h.
Local Notation reached_by := (reached_by foretells confirms confirm_cost).

Lemma program_run k c d n C : reached_by n C c -> knows k c d ->
  exists t k' c' d' n', [/\ machine (size t) (Return k) d = (t, Some (estimate k'), d'),
    reached_by n' (C + size t) c', knows k' c' d' & unexplored k' = [::]].
Proof.
have [N] := ubnP (edges W - n); elim: N k c d n C => // N IH k c d n C lN R K.
case: (boolP (unexplored k == [::])) => [/eqP U|U].
  by exists [::], k, c, d, n; rewrite addn0; split=> //=; rewrite U.
have [C0 R0] := reached_by_reached decides R.
have [k1 [z [n1 [c1 [[t1 [E1 s1]] P1 K1]]]]] := one_pass_makes (reached_sound R0) K U.
have R1 := ReachedByPass R P1; have [|t [k' [c' [d' [n' [A D F G]]]]]] := IH _ _ _ _ _ _ R1 K1.
  have [C1 R'] := reached_by_reached decides R1.
  by rewrite ltnS in lN; apply: leq_trans lN; apply: ltn_sub2l => //; exact: (run_passes R').
exists (t1 ++ t), k', c', d', n'; split=> //; last by rewrite size_cat addnA s1.
by rewrite size_cat (machine_next _ _ (next_pass U)); exact: (machine_exec E1 A).
Qed.

(* ---- The estimate is the world, seen from where the robot is ---- *)
Lemma estimate_denotes S h t : known S h -> (forall e, ~~ is_open S e) ->
  (forall e f, partner S e = Some f -> known S f) ->
  let answer := NumberedMap [seq number_of S (turn S 1 e) | e <- darts S]
      [seq number_of S (odflt e (partner S e)) | e <- darts S] (number_of S (turn S t h)) in
  isomorphic (denote answer) (map_with_robot S (turn S t h)).
Proof.
move=> kh nopen Hl answer; pose f i := nth (0, 0) (darts S) i.
have nK e : known S e -> number_of S e < size (darts S) /\ f (number_of S e) = e.
  by move=> ke; rewrite /number_of index_mem mem_darts ke /f nth_index // mem_darts.
have kf i : i < size (darts S) -> known S (f i) by move=> li; rewrite -mem_darts mem_nth.
have kp e : known S e -> known S (odflt e (partner S e)).
  by case E: (partner S e) => [g|] //= _; exact: Hl E.
exists f, (number_of S); split.
- move=> i; rewrite /= size_map => li; split.
  + exact: kf.
  + by rewrite /number_of index_uniq ?darts_uniq.
  + by rewrite /= (nth_map (0, 0)) //; have [_ ->] := nK _ (known_turn 1 (kf i li)).
  + by rewrite /= (nth_map (0, 0)) //; have [_ ->] := nK _ (kp _ (kf i li)).
- by move=> e ke; rewrite /= size_map; exact: nK.
by have [_ ->] := nK _ (known_turn t kh).
Qed.

Lemma estimate_right k c d : sound c -> knows k c d -> unexplored k = [::] ->
  [/\ nothing_open c, valid (estimate k) & isomorphic (denote (estimate k)) (rooted d)].
Proof.
case=> r [I kh ph _] [_ ES Eh [_ mU] du] U; rewrite ES Eh in I kh ph.
set S := known_map k in I kh *; set h := at_dart k in kh ph.
have nopen e : ~~ is_open S e by rewrite -mU U.
have X := complete_when_nothing_open I nopen.
have Hl x y : partner S x = Some y -> known S y.
  by move=> P; have [_ ? _ _] := embedded_links I (partnerP P).
set t := opposite (degree_in S h.1) (due_turn k).
have kt : known S (turn S t h) by exact: known_turn.
have Hd : phi r (turn S t h) = d.
  have [l1 _] := knownP I kh; rewrite (phi_turn I) // -ph -du /t (degree_phi I l1).
  rewrite -(degree_same (phi_vertex v0 r h)) -ph -du.
  by rewrite (degree_same (fconnect_iter sigma _ d)) opposite_turn.
have J := isomorphic_trans (estimate_denotes t kh nopen Hl) (complete_isomorphic I X kt).
rewrite Hd in J; split=> //; first by rewrite /nothing_open ES.
have nK e : known S e -> number_of S e < size (darts S) by rewrite /number_of index_mem mem_darts.
have nP g : (forall e, known S e -> known S (g e)) -> forall i, i < size (darts S) ->
    nth 0 [seq number_of S (g e) | e <- darts S] i < size (darts S).
  move=> kg i li; rewrite (nth_map (0, 0)) //; apply/nK/kg.
  by rewrite -mem_darts mem_nth.
apply: validI; last by rewrite /= !size_map.
apply: (isomorphic_wellformed J (rooted_wellformed d)) => /=; rewrite ?size_map.
- exact: nK.
- by move=> i; apply: nP => e; exact: known_turn.
move=> i; apply: nP => e ke; case E: (partner S e) => [g|] //=; exact: Hl E.
Qed.

(* with any budget that is large enough *)
Variable set_out_cost : nat.
Hypothesis set_out_makes : exists k z,
  makes (set_out L (senses v0)) v0 k z set_out_cost /\ knows k (initial W) z.
Local Notation bound := (set_out_cost + bound_by W confirm_cost).

Theorem explorer_by_correct budget : bound <= budget -> exists transcript answer z,
  [/\ episode (explorer_by L pol) (rooted v0) senses budget = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; have [k0 [z0 [[t0 [E0 s0]] K0]]] := set_out_makes.
have [t [k [c [d [n [A R K U]]]]]] := program_run (ReachedByStart _ _ _) K0.
have [C0 R0] := reached_by_reached decides R.
have [nopen V J] := estimate_right (reached_sound R0) K U.
have [_ Cb _] := run_by_correct decides R nopen; rewrite add0n in Cb.
have Cb' : size (t0 ++ t) <= bound by rewrite size_cat s0 leq_add2l.
exists (t0 ++ t), (estimate k), d; split=> //; rewrite -(subnKC (leq_trans Cb' le)).
apply: explore_more; rewrite explore_machine size_cat; exact: (machine_exec E0 A).
Qed.
End InWorld.

(* ---- Algorithm 1, with a directional lighthouse ---- *)
Section Directional.
Variables (W : lighthouse_world) (pol : policy).
Local Notation v0 := (@start W).
Local Notation always := (fun _ _ (_ : W) => true).
Local Notation senses := (@percept_of W).

Lemma nothing_to_confirm k f (y : W) c d : due c d y -> exists c' z,
  makes senses (confirm directional k f c) d (true, c') z 0 /\ due c' z y.
Proof. by exists c, d; split=> //; exact: makes_return. Qed.

Lemma directional_decides S r h w f (x : W) : embedded v0 S r -> known S h ->
  follow S w h = Some f -> f.1 = 0 ->
  matches (foretells directional) always S x (h, w) f <-> x = phi v0 r h.
Proof.
by move=> I kh R f0; rewrite directional_matches -(test_iff I x kh R f0); split=> /eqP.
Qed.

Theorem one_pass_is_pass k c d : sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes senses (one_pass directional pol k) d k' z n,
    pass (next_edge pol k) c n c' & knows k' c' z].
Proof.
move=> Ok K U.
have [//|//|k0 f y c0 d0 _ _ _|k' [z [n [c' [A P K']]]]] :=
  @one_pass_makes W _ _ directional pol senses always 0 _ _ _ k c d Ok K U.
  exact: nothing_to_confirm.
by exists k', z, n, c'; split=> //; exact: directional_pass.
Qed.

Theorem algorithm1_correct budget : paper_bound (vertices W) (edges W) <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (rooted v0) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= paper_bound (vertices W) (edges W),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
have <- : 0 + bound_by W 0 = paper_bound (vertices W) (edges W).
  by rewrite /bound_by mul0n addn0.
apply: (@explorer_by_correct W _ _ directional pol senses always) => //.
- by move=> k f y c d _ _ _; exact: nothing_to_confirm.
- exact: directional_decides.
exists (first_knowledge (percept_of v0)), v0; split; first exact: makes_return.
by split=> //; [rewrite /= bearing_start | exact: queue_initial].
Qed.

Corollary algorithm1_right : right denote (algorithm1 pol) (rooted v0) (@percept_of W).
Proof.
have [t [e [z [A _ V J]]]] := algorithm1_correct (leqnn _).
by exists (paper_bound (vertices W) (edges W)), t, e, z; split=> //; exact: validP.
Qed.
End Directional.

(* worlds with a directional lighthouse that no motion tells apart are the same rooted map *)
Corollary directional_unambiguous (W1 W2 : lighthouse_world) (R : W1 -> W2 -> Prop) :
  (forall x y, R x y -> percept_of x = percept_of y) ->
  (forall x y, R x y -> R (sigma x) (sigma y)) -> (forall x y, R x y -> R (alpha x) (alpha y)) ->
  R start start -> isomorphic (rooted (@start W1)) (rooted (@start W2)).
Proof.
move=> Ro Rs Ra R0.
pose oldest := Policy (fun _ => (0, 0)) (fun _ _ => [::]) (fun _ _ hs => hs) (fun _ _ => [::]).
apply: (@twins_impossible _ _ denote (algorithm1 oldest) (rooted start) (rooted start)
  (@percept_of W1) (@percept_of W2) R) => //; try exact: rooted_wellformed.
- exact: algorithm1_right.
- exact: algorithm1_right.
Qed.

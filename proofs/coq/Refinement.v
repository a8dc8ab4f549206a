(* ---------------------------------------------------------------------------------------------
   The program is an instance of the relation: every pass of one_pass is a `pass`, step for step, under
   every policy and in every world.                                          Sections IV, V and VI

     routeP               the breadth-first path is a path, shorter than S has vertices.
     makes p d x z n      run in the world from dart d, program p gives x, at dart z, after n
                          traversals.
     due c d x            a robot at d that turns by c is as if it had come in by x.
     trail done y x       the motions in done lead from x to y.
     one_pass_is_pass     the refinement.
     estimate_right       when U is empty the estimate is the world seen from the robot's true
                          dart.
     episode_machine      the explorer, which remembers all percepts, is the machine, which does
                          not.
     algorithm1_correct   in every world with a directional lighthouse, under every policy, with
                          any budget of at least (1)+(2) traversals: it stops after at most
                          (1)+(2), and is right.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers Indistinguishable PartialMaps
  HypothesisTests Paths.
From Allworlds Require Import Pass Cost Correctness Algorithm.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Breadth-first search finds every vertex that can be reached ---- *)
Section RouteP.
Variables (S : partial_map) (a : dart).
Hypothesis ka : known S a.
Hypothesis Hl : forall x y, partner S x = Some y -> known S y.
Definition good (T : seq branch) := uniq (unzip1 T) /\ forall j, j < size T ->
  let t := nth no_branch T j in
  [/\ follow S t.2.1 a = Some t.2.2, t.2.2.1 = t.1, known S t.2.2 & size t.2.1 <= j].
Lemma visits w c ks T : follow S w a = Some c -> size w < size T -> good T ->
  exists X, [/\ foldl (visit S w c) T ks = T ++ X, good (T ++ X) &
    forall k g, k \in ks -> partner S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ X)].
Proof.
move=> R; elim: ks T => [|k ks IH] T sw G /=; first by exists [::]; rewrite cats0.
have [Y [E GY HY]] : exists Y, [/\ visit S w c T k = T ++ Y, good (T ++ Y) &
    forall g, partner S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ Y)].
  rewrite /visit; case L: (partner S _) => [g|]; last by exists [::]; rewrite cats0.
  case: ifP => gT; first by exists [::]; rewrite cats0; split=> // g' [<-].
  exists [:: (g.1, (rcons w k, g))]; rewrite cats1; split=> //; last first.
    by move=> g' [<-]; rewrite /unzip1 map_rcons mem_rcons inE eqxx.
  have [U H] := G; split; first by rewrite /unzip1 map_rcons rcons_uniq gT.
  move=> j; rewrite size_rcons nth_rcons ltnS leq_eqVlt => /orP[/eqP->|lj]; last by rewrite lj;
    exact: H.
  rewrite ltnn eqxx /=; split=> //; last by rewrite size_rcons.
    by rewrite -cats1 (follow_cat _ R) /= L.
  exact: (Hl L).
have [|X [EX GX HX]] := IH (T ++ Y) _ GY; first by rewrite size_cat ltn_addr.
rewrite E; exists (Y ++ X); rewrite catA; split=> // k' g; rewrite inE => /orP[/eqP->|] L;
  last exact: HX.
by rewrite /unzip1 map_cat mem_cat HY.
Qed.

(* the neighbours of the first i vertices have been found *)
Definition done_to i (T : seq branch) := forall j, j < i -> forall p g,
  let c := (nth no_branch T j).2.2 in
  p < degree_in S c.1 -> partner S (c.1, p) = Some g -> g.1 \in unzip1 T.
Lemma good_size T : good T -> size T <= size (degrees S).
Proof.
case=> U H; rewrite -(size_map fst) -[X in _ <= X](size_iota 0); apply: uniq_leq_size => // v.
case/(nthP 0)=> j; rewrite size_map => lj <-; rewrite (nth_map no_branch) // mem_iota /=.
by have [_ <- /andP[]] := H j lj.
Qed.

Lemma growP fuel i T : good T -> i <= size T -> size (degrees S) <= fuel + i -> done_to i T ->
  let T' := grow S fuel i T in [/\ good T', done_to (size T') T' & {subset unzip1 T <= unzip1 T'}].
Proof.
elim: fuel i T => [|fl IH] i T G li ns Dn /=.
  have E : i = size T by apply/eqP; rewrite eqn_leq li /=; exact: leq_trans (good_size G) ns.
  by rewrite -E; split.
case: ifP => [lt|/negbT]; last first.
  by rewrite -leqNgt => le; have E : i = size T by [apply/eqP; rewrite eqn_leq li]; rewrite -E; split.
set t := (nth no_branch T i).2; have [U H] := G; have [R e1 kc sw] := H i lt.
have [X [E GX HX]] := visits (round S t.2) R (leq_ltn_trans sw lt) G.
rewrite E; have [|||A B C] := IH i.+1 (T ++ X) GX.
- by rewrite size_cat ltn_addr.
- by rewrite addnS -addSn.
- move=> j; rewrite ltnS leq_eqVlt => /orP[/eqP->|lj] p g; rewrite /= nth_cat.
    rewrite lt -/t => lp L; have [lc _] := andP kc.
    apply: (HX (degree_in S t.2.1 - t.2.2 + p)); first by rewrite map_f ?mem_iota.
    by rewrite (@turn_to S t.2 (t.2.1, p)) //; apply/andP.
  rewrite (ltn_trans lj lt) => lp L; rewrite /unzip1 map_cat mem_cat; apply/orP; left.
  exact: (Dn j lj p g).
by split=> // v vT; apply: C; rewrite /unzip1 map_cat mem_cat vT.
Qed.

Lemma routeP v : joined S a v -> let way := route S a v in
  [/\ follow S way.1 a = Some way.2, way.2.1 = v & size way.1 < size (degrees S)].
Proof.
move=> [w [f [R fv]]]; rewrite /route; set T := tree S a.
have [||||G Dn Sub] := @growP (size (degrees S)) 0 [:: (a.1, ([::], a))] => //.
- by split=> // -[|j].
- by rewrite addn0.
rewrite -[grow _ _ _ _]/T in G Dn Sub.
have cl x : known S x -> x.1 \in unzip1 T -> forall w f, follow S w x = Some f -> f.1 \in unzip1 T.
  move=> kx xT w' f'; elim: w' x kx xT => [|k w' IH] x kx xT /=; first by case=> <-.
  case L: (partner S _) => [g|] //; apply: IH; first exact: (Hl L).
  have [U H] := G; set j := index x.1 (unzip1 T).
  have lj : j < size T by rewrite -(size_map fst) index_mem.
  have [_ c1 kc _] := H j lj; set c := (nth no_branch T j).2.2 in c1 kc.
  have cx : c.1 = x.1.
    by rewrite c1 -(nth_map no_branch 0 fst) // nth_index.
  have dx : 0 < degree_in S x.1 by case/andP: kx => _; case: (degree_in S _).
  by apply: (Dn j lj ((x.2 + k) %% degree_in S x.1)); rewrite -/c cx ?ltn_mod.
have vT : v \in unzip1 T by rewrite -fv; apply: (cl a ka _ w f R); apply: Sub; rewrite /= inE.
have lj : index v (unzip1 T) < size T by rewrite -(size_map fst) index_mem.
have [U H] := G; have [A B _ C] := H _ lj; split=> //.
  by rewrite B -(nth_map no_branch 0 fst) // nth_index.
exact: leq_ltn_trans C (leq_trans lj (good_size G)).
Qed.

Lemma route_or_elseP w v : joined S a v -> let way := route_or_else S w a v in
  [/\ follow S way.1 a = Some way.2, way.2.1 = v & size way.1 < size (degrees S)].
Proof.
move/routeP=> R; rewrite /route_or_else; case F: (follow S w a) => [f|] //.
by case: ifP => // /andP[/eqP fv sw].
Qed.
End RouteP.

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
Lemma explore_machine pol (M : rooted_map) (senses : carrier M -> percept) budget o seen d :
  explore (algorithm1 pol) M senses budget (o :: seen) d
  = machine pol (motion_in M) senses budget (foldl (sense pol) (Return (first_knowledge o)) seen) d.
Proof.
elim: budget seen d => [|n IH] seen d /=; rewrite /act; case E: (next pol _) => [e|[k f]] //.
rewrite IH.
have -> : foldl (sense pol) (Return (first_knowledge o)) (rcons seen (senses (motion_in M k d)))
    = f (senses (motion_in M k d)).
  by rewrite -cats1 foldl_cat /= /sense E.
by [].
Qed.

Theorem episode_machine pol (M : rooted_map) (senses : carrier M -> percept) budget :
  episode (algorithm1 pol) M senses budget
  = machine pol (motion_in M) senses budget (Return (first_knowledge (senses (root M)))) (root M).
Proof. exact: explore_machine. Qed.

(* ---- A program in a world ---- *)
Section InWorld.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation b := (first_bearing W).
Local Notation program := (program percept).

Fixpoint exec A (p : program A) (d : W) : A * W * seq (nat * percept) :=
  match p with
  | Return x => (x, d, [::])
  | Go k f =>
      let: (x, z, t) := exec (f (percept_of (motion k d))) (motion k d) in
      (x, z, (k, percept_of (motion k d)) :: t)
  end.
Definition makes A (p : program A) d x z n := exists t, exec p d = (x, z, t) /\ size t = n.

Lemma makes_return A (x : A) d : makes (Return x) d x d 0.
Proof. by exists [::]. Qed.

Lemma makes_go A k (f : percept -> program A) d x z n :
  makes (f (percept_of (motion k d))) (motion k d) x z n -> makes (Go k f) d x z n.+1.
Proof. by case=> t [E <-]; exists ((k, percept_of (motion k d)) :: t); rewrite /= E. Qed.

Lemma makes_bind A B (p : program A) (f : A -> program B) d x z n y z' n' :
  makes p d x z n -> makes (f x) z y z' n' -> makes (bind p f) d y z' (n + n').
Proof.
case=> t [E <-] F; elim: p d t E => [x'|k g IH] d t /=; first by case=> -> -> <-.
case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1; rewrite addSn; apply: makes_go.
exact: (IH _ _ _ E).
Qed.

Definition due c (d x : W) := iter c sigma d = x.

Lemma motion_due c d x k : due c d x -> motion (c + k) d = motion k x.
Proof. by move=> <-; rewrite /motion addnC iterD. Qed.

Lemma walk_to_makes w k c d x : due c d x ->
  makes (walk_to w k c) d (percept_of (motion k (walk w x))) (motion k (walk w x)) (size w).+1.
Proof.
elim: w c d x => [|j w IH] c d x du /=; apply: makes_go; rewrite (motion_due _ du).
  exact: makes_return.
exact: IH.
Qed.

Fixpoint trail (done : seq (nat * nat)) (y x : W) :=
  if done is q :: done' then
    exists z, [/\ y = motion q.1 z, q.2 = degree z & trail done' z x]
  else y = x.

(* line 15: the robot retraces, coming back to v_u and resuming its orientation *)
Lemma go_back_makes done c d y x : due c d y -> trail done y x ->
  exists c' z, makes (go_back done c) d c' z (size done) /\ due c' z x.
Proof.
elim: done c d y => [|[k n] done IH] c d y du /=.
  by move=> <-; exists c, d; split=> //; exact: makes_return.
case=> z [Y N T]; have E : motion c d = iter k sigma z.
  by rewrite -[c]addn0 (motion_due 0 du) Y /motion /= alphaK.
have [|c' [z' [A B]]] := IH (opposite n k) (motion c d) z _ T.
  by rewrite E N; exact: opposite_turn.
by exists c', z'; split=> //; exact: makes_go.
Qed.

Lemma check_path_makes w P done c d y x :
  due c d y -> size P = (size w).+1 -> trail done y x ->
  exists done' c' z y',
    let j := find (fun q => q.1 != q.2) (zip (percepts_along w y) P) in
    if percepts_along w y == P then
      makes (check_path w P done c (percept_of y)) d (true, done', c') z (size w) /\ due c' z (walk w y)
    else [/\ makes (check_path w P done c (percept_of y)) d (false, done', c') z j,
             due c' z y', trail done' y' x & size done' = size done + j].
Proof.
elim: w P done c d y => [|k w IH] [|e0 P] done c d y du //= [sz] T.
  case: P sz => // _; exists done, c, d, y; rewrite eqseq_cons eqxx andbT.
  by case: (percept_of y =P e0) => E /=; rewrite ?addn0; split=> //; exact: makes_return.
rewrite eqseq_cons; case: (percept_of y =P e0) => E /=; last first.
  by exists done, c, d, y; split; rewrite ?addn0 //; exact: makes_return.
have T' : trail ((k, (percept_of y).1) :: done) (motion k y) x by exists y.
have [done' [c' [z [y' H]]]] := IH P _ 0 (motion k y) (motion k y) (erefl _) sz T'.
exists done', c', z, y'; move: H; case: ifP => _ /=.
  by case=> A B; split=> //; apply: makes_go; rewrite (motion_due k du).
by case=> A B C F; split=> //; [apply: makes_go; rewrite (motion_due k du) | rewrite F addSnnS].
Qed.

Variable pol : policy.

(* lines 7-17 *)
Lemma test_all_makes k e (x : W) hs c d : bearing0 k = b ->
  (forall h, h \in hs -> [/\ is_open (known_map k) h, h != e &
     leads_home (known_map k) h (way_home pol k h).1 (way_home pol k h).2]) ->
  uniq hs -> due c d x ->
  exists ts, [/\ forall t, t \in ts -> rejected (known_map k) e x t,
    {subset unzip1 ts <= hs}, uniq (unzip1 ts) &
    (unzip1 ts = hs /\ exists c' z,
       makes (test_all pol k (percept_of x) hs c) d (None, c') z (tests_cost (known_map k) x ts)
       /\ due c' z x)
    \/ exists h c' z, let way := way_home pol k h in
      [/\ h \in hs, uniq (h :: unzip1 ts),
          percepts_along way.1 x = expected_percepts b (known_map k) way.1 h,
          makes (test_all pol k (percept_of x) hs c) d (Some (h, way.2), c') z
            (tests_cost (known_map k) x ts + size way.1) & due c' z (walk way.1 x)]].
Proof.
move=> kb; set S := known_map k; elim: hs c d => [|h hs IH] c d H U du.
  exists [::]; split=> //; left; split=> //; exists c, d; rewrite /tests_cost big_nil.
  by split=> //; exact: makes_return.
have [oh he Lh] := H h (mem_head _ _); have [R f0 sw] := Lh; have /andP[hU U'] := U.
set w := (way_home pol k h).1 in Lh R sw; set f := (way_home pol k h).2 in Lh R f0.
have sz := size_expected W R.
have [done [c' [z [y' CK]]]] := check_path_makes du sz (erefl : trail [::] x x).
move: CK => /=; case: ifP => [/eqP V [A B]|/eqP V [A B T F]].
  exists [::]; split=> //; right; exists h, c', z; rewrite -/w -/f; split=> //; first exact: mem_head.
  rewrite /tests_cost big_nil add0n -[size w]addn0 /= kb; apply: (makes_bind A); exact: makes_return.
have [c2 [z2 [A2 B2]]] := go_back_makes B T; rewrite /= add0n in F; rewrite -F in A.
have [|ts [Rj Sb Ut HH]] := IH c2 z2 _ U' B2; first by move=> h' m; apply: H; rewrite inE m orbT.
have tc : tests_cost S x ((h, w) :: ts) = size done + size done + tests_cost S x ts.
  by rewrite /tests_cost big_cons /steps_walked /= addnn -mul2n F.
exists ((h, w) :: ts); split=> /=.
- move=> t; rewrite inE => /orP[/eqP->|m]; last exact: Rj.
  by split=> //; exists f.
- by move=> q; rewrite !inE => /orP[->//|/Sb->]; rewrite orbT.
- by rewrite Ut andbT; apply: contra hU; exact: Sb.
rewrite kb; case: HH => [[<- [c3 [z3 [A3 B3]]]]|[g [c3 [z3 [mg Ug Vg A3 B3]]]]]; [left|right].
  split=> //; exists c3, z3; split=> //; rewrite tc -addnA /=.
  apply: (makes_bind A); exact: (makes_bind A2 A3).
exists g, c3, z3; split=> //; first by rewrite inE mg orbT.
  move: Ug => /= /andP[gt _]; rewrite inE negb_or gt Ut !andbT; apply/andP; split.
    by apply/eqP=> gh; move: hU; rewrite -gh mg.
  by apply: contra hU; exact: Sb.
rewrite tc -!addnA /=; apply: (makes_bind A); exact: (makes_bind A2 A3).
Qed.

(* ---- One pass of the program is a pass of the relation ---- *)
Definition knows k (c : configuration W) (d : W) :=
  [/\ bearing0 k = b, mapped c = known_map k, here c = at_dart k,
      queue_of (known_map k) (unexplored k) & due (due_turn k) d (robot c)].

Theorem one_pass_is_pass k c d : sound c -> knows k c d -> unexplored k != [::] ->
  exists k' z n c', [/\ makes (one_pass pol k) d k' z n, pass (next_edge pol k) c n c'
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
  by move=> L; have [_ ? _ _] := embedded_links I (partnerP L).
have [R g1 sw0] : let way := way_to pol k e in
    [/\ follow S way.1 h0 = Some way.2, way.2.1 = e.1 & size way.1 < size (degrees S)].
  apply: route_or_elseP => //; have [[w [f [Rw f0]]] _] := Rc h0 kh; have [_ A] := Rc e ke.
  by have [kf _] := follow_phi I kh Rw; exact: (joined_trans Rw (joined_turn A kf f0)).
rewrite /one_pass -/S -/e; set w0 := (way_to pol k e).1 in R sw0 *.
set g := (way_to pol k e).2 in R g1 *.
have [kg _] := follow_phi I kh R; have T := turn_to kg ke g1; set j := (_ + _) in T *.
have Tr : transit S h0 e w0 j by split=> //; exists g.
have Wk := walk_to_makes w0 j du; set x := motion j (walk w0 p) in Wk.
set hs := hypotheses pol k e (percept_of x).
pose H := [seq h <- unexplored k | (h != e) && (expected_percept b S h == percept_of x)].
have pH : perm_eq hs H by rewrite /hs /hypotheses -/S kb -/H; case: ifP.
have mH h : (h \in hs) = [&& h != e, expected_percept b S h == percept_of x & is_open S h].
  by rewrite (perm_mem pH) mem_filter mU andbA.
have Uh : uniq hs by rewrite (perm_uniq pH) filter_uniq.
have Hh h : h \in hs -> [/\ is_open S h,
  h != e & leads_home S h (way_home pol k h).1 (way_home pol k h).2].
  rewrite mH => /and3P[he _ oh]; have [kh' _] := andP oh.
  by have [Ra Rb Rd] := route_or_elseP kh' Hl (choose_home pol k h) (proj1 (Rc h kh')).
have [ts [Rj Sb Ut HH]] := test_all_makes kb Hh Uh (erefl (iter 0 sigma x)).
case: HH => [[E [c' [z [A B]]]]|[h [c' [z [mh Uh' V A B]]]]].
  exists (augment k e (percept_of x) (None, c')), z; do 2 eexists; split.
  - apply: (makes_bind Wk); apply: (makes_bind A); exact: makes_return.
  - rewrite addn0 -[_.+1]addn1.
    apply: (@VertexPass W e S h0 p w0 j ts Tr Rj Ut) => h oh he sg.
    by rewrite E mH he sg eqxx oh.
  split=> //=; apply: queue_vertex => // y /exploredP[f m].
  by have [? _ _ _] := embedded_links I m.
have [oh he Lh] := Hh h mh.
exists (augment k e (percept_of x) (Some (h, (way_home pol k h).2), c')), z; do 2 eexists; split.
- apply: (makes_bind Wk); apply: (makes_bind A); exact: makes_return.
- rewrite addn0 addnA -[_.+1]addn1.
  exact: (@LoopPass W e S h0 p w0 j ts h _ _ Tr Rj Uh' oh he Lh V).
by split=> //=; exact: queue_loop.
Qed.

(* ---- The whole run ---- *)
Local Notation machine := (machine pol motion (@percept_of W)).

Lemma machine_next fuel p q d : next pol p = next pol q -> machine fuel p d = machine fuel q d.
Proof. by case: fuel => [|fuel] /= ->. Qed.

Lemma next_pass k : unexplored k != [::] -> next pol (Return k) = next pol (one_pass pol k).
Proof.
rewrite /=; case E: (unexplored k) => // _.
by rewrite /one_pass; case: (way_to pol k (next_edge pol k)).1.
Qed.

Lemma machine_exec p d s z t fuel t' e z' :
  exec p d = (s, z, t) -> machine fuel (Return s) z = (t', Some e, z') ->
  machine (size t + fuel) p d = (t ++ t', Some e, z').
Proof.
move=> E F; elim: p d t E => [x|k g IH] d t; first by case=> -> -> <-.
rewrite [exec _ _]/=; case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1.
by rewrite [size _]/= addSn [Algorithm.machine _ _ _ _ _ _]/= (IH _ _ _ E).
Qed.

Lemma program_run k c d n C : reached n C c -> knows k c d ->
  exists t k' c' d' n', [/\ machine (size t) (Return k) d = (t, Some (estimate k'), d'),
    reached n' (C + size t) c', knows k' c' d' & unexplored k' = [::]].
Proof.
have [N] := ubnP (edges W - n); elim: N k c d n C => // N IH k c d n C lN R K.
case: (boolP (unexplored k == [::])) => [/eqP U|U].
  by exists [::], k, c, d, n; rewrite addn0; split=> //=; rewrite U.
have [k1 [z [n1 [c1 [[t1 [E1 s1]] P1 K1]]]]] := one_pass_is_pass (reached_sound R) K U.
have R1 := ReachedPass R P1; have [|t [k' [c' [d' [n' [A B F G]]]]]] := IH _ _ _ _ _ _ R1 K1.
  by rewrite ltnS in lN; apply: leq_trans lN; apply: ltn_sub2l => //; exact: (run_passes R1).
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
  by move=> L; have [_ ? _ _] := embedded_links I (partnerP L).
set t := opposite (degree_in S h.1) (due_turn k).
have kt : known S (turn S t h) by exact: known_turn.
have Hd : phi v0 r (turn S t h) = d.
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

(* with any budget of at least (1) + (2) traversals *)
Theorem algorithm1_correct budget : paper_bound (vertices W) (edges W) <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (rooted v0) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= paper_bound (vertices W) (edges W),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; pose k0 := first_knowledge (percept_of v0).
have K0 : knows k0 (initial W) v0.
  split=> //; last exact: queue_initial.
  by rewrite /= bearing_start.
have [t [k [c [d [n [A R K U]]]]]] := program_run (ReachedStart W) K0.
have [nopen V J] := estimate_right (reached_sound R) K U.
have [_ Cb _] := run_correct R nopen; rewrite add0n in Cb.
exists t, (estimate k), d; split=> //; rewrite -(subnKC (leq_trans Cb le)).
by apply: explore_more; rewrite (explore_machine pol).
Qed.

Corollary algorithm1_right : right denote (algorithm1 pol) (rooted v0) (@percept_of W).
Proof.
have [t [e [z [A _ V J]]]] := algorithm1_correct (leqnn _).
by exists (paper_bound (vertices W) (edges W)), t, e, z; split=> //; exact: validP.
Qed.
End InWorld.

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

(* Refine.v -- the program of Algorithm.v refines the relation of Lighthouse.v, in every world.   coqc -Q . Lighthouse Refine.v *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Rooted.
From Allworlds Require Import Lighthouse Algorithm.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- 1. Routes: breadth-first search finds every reachable vertex in fewer steps than there are vertices ---- *)
Section RouteP.
Variables (S : state) (a : dart).
Hypothesis ka : known S a.
Hypothesis Hl : forall x y, link S x = Some y -> known S y.
Definition good (T : seq entry) := uniq (unzip1 T) /\ forall j, j < size T -> let t := nth entry0 T j in
  [/\ srun S t.2.1 a = Some t.2.2, t.2.2.1 = t.1, known S t.2.2 & size t.2.1 <= j].
Lemma visits w c ks T : srun S w a = Some c -> size w < size T -> good T ->
  exists X, [/\ foldl (visit S w c) T ks = T ++ X, good (T ++ X) &
    forall k g, k \in ks -> link S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ X)].
Proof.
move=> R; elim: ks T => [|k ks IH] T sw G /=; first by exists [::]; rewrite cats0.
have [Y [E GY HY]] : exists Y, [/\ visit S w c T k = T ++ Y, good (T ++ Y) &
    forall g, link S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ Y)].
  rewrite /visit; case L: (link S _) => [g|]; last by exists [::]; rewrite cats0.
  case: ifP => gT; first by exists [::]; rewrite cats0; split=> // g' [<-].
  exists [:: (g.1, (rcons w k, g))]; rewrite cats1; split=> //; last first.
    by move=> g' [<-]; rewrite /unzip1 map_rcons mem_rcons inE eqxx.
  have [U H] := G; split; first by rewrite /unzip1 map_rcons rcons_uniq gT.
  move=> j; rewrite size_rcons nth_rcons ltnS leq_eqVlt => /orP[/eqP->|lj]; last by rewrite lj; exact: H.
  rewrite ltnn eqxx /=; split=> //; last by rewrite size_rcons.
    by rewrite -cats1 (srun_cat _ R) /= L.
  exact: (Hl L).
have [|X [EX GX HX]] := IH (T ++ Y) _ GY; first by rewrite size_cat ltn_addr.
rewrite E; exists (Y ++ X); rewrite catA; split=> // k' g; rewrite inE => /orP[/eqP->|] L; last exact: HX.
by rewrite /unzip1 map_cat mem_cat HY.
Qed.
Definition done_to i (T : seq entry) := forall j, j < i -> forall k g, let c := (nth entry0 T j).2.2 in
  k < deg S c.1 -> link S (turn S k c) = Some g -> g.1 \in unzip1 T.
Lemma good_size T : good T -> size T <= size (degs S).
Proof.
case=> U H; rewrite -(size_map fst) -[X in _ <= X](size_iota 0); apply: uniq_leq_size => // v.
case/(nthP 0)=> j; rewrite size_map => lj <-; rewrite (nth_map entry0) // mem_iota /=.
by have [_ <- /andP[]] := H j lj.
Qed.
Lemma growP fuel i T : good T -> i <= size T -> size (degs S) <= fuel + i -> done_to i T ->
  let T' := grow S fuel i T in [/\ good T', done_to (size T') T' & {subset unzip1 T <= unzip1 T'}].
Proof.
elim: fuel i T => [|fl IH] i T G li ns Dn /=.
  have E : i = size T by apply/eqP; rewrite eqn_leq li /=; exact: leq_trans (good_size G) ns.
  by rewrite -E; split.
case: ifP => [lt|/negbT]; last first.
  by rewrite -leqNgt => le; have E : i = size T by [apply/eqP; rewrite eqn_leq li]; rewrite -E; split.
set t := (nth entry0 T i).2; have [U H] := G; have [R e1 kc sw] := H i lt.
have [X [E GX HX]] := visits (iota 0 (deg S t.2.1)) R (leq_ltn_trans sw lt) G.
rewrite E; have [|||A B C] := IH i.+1 (T ++ X) GX.
- by rewrite size_cat ltn_addr.
- by rewrite addnS -addSn.
- move=> j; rewrite ltnS leq_eqVlt => /orP[/eqP->|lj] k g; rewrite /= nth_cat.
    by rewrite lt => lk; apply: HX; rewrite mem_iota.
  rewrite (ltn_trans lj lt) => lk L; rewrite /unzip1 map_cat mem_cat; apply/orP; left; exact: (Dn j lj k g).
by split=> // v vT; apply: C; rewrite /unzip1 map_cat mem_cat vT.
Qed.
Lemma routeP v : rch S a v -> let wf := route S a v in
  [/\ srun S wf.1 a = Some wf.2, wf.2.1 = v & size wf.1 < size (degs S)].
Proof.
move=> [w [f [R fv]]]; rewrite /route; set T := tree S a.
have [||||G Dn Sub] := @growP (size (degs S)) 0 [:: (a.1, ([::], a))] => //.
- by split=> // -[|j].
- by rewrite addn0.
rewrite -[grow _ _ _ _]/T in G Dn Sub.
have cl x : known S x -> x.1 \in unzip1 T -> forall w f, srun S w x = Some f -> f.1 \in unzip1 T.
  move=> kx xT w' f'; elim: w' x kx xT => [|k w' IH] x kx xT /=; first by case=> <-.
  case L: (link S _) => [g|] //; apply: IH; first exact: (Hl L).
  have [U H] := G; set j := index x.1 (unzip1 T).
  have lj : j < size T by rewrite -(size_map fst) index_mem.
  have [_ c1 kc _] := H j lj; set c := (nth entry0 T j).2.2 in c1 kc.
  have cx : c.1 = x.1.
    by rewrite c1 -(nth_map entry0 0 fst) // nth_index.
  have d0 : 0 < deg S c.1 by case/andP: kc => _; case: (deg S _).
  apply: (Dn j lj ((deg S x.1 - c.2 + (x.2 + k)) %% deg S c.1)); rewrite ?ltn_mod //.
  rewrite -/c -L; congr (link S _); case/andP: kc => _ lc; rewrite /turn modnDmr cx; congr (_, _).
  by rewrite addnA subnKC ?modnDl // -cx ltnW.
have vT : v \in unzip1 T by rewrite -fv; apply: (cl a ka _ w f R); apply: Sub; rewrite /= inE.
have lj : index v (unzip1 T) < size T by rewrite -(size_map fst) index_mem.
have [U H] := G; have [A B _ C] := H _ lj; split=> //.
  by rewrite B -(nth_map entry0 0 fst) // nth_index.
exact: leq_ltn_trans C (leq_trans lj (good_size G)).
Qed.
End RouteP.

(* ---- 2. The program in a world ---- *)
Section InWorld.
Variable D : finType.
Variables sigma alpha : D -> D.
Hypothesis sigma_inj : injective sigma.
Hypothesis alphaK : involutive alpha.
Hypothesis alphaN : forall d, alpha d != d.
Hypothesis conn : forall x y, connect (adj sigma alpha) x y.
Variables d0 pt : D.
Hypothesis pt0 : fconnect sigma d0 pt.
Local Notation mv := (Lighthouse.mv sigma alpha).
Local Notation run := (Lighthouse.run sigma alpha).
Local Notation obs := (Lighthouse.obs sigma pt).
Local Notation trace := (Lighthouse.trace sigma alpha pt).
Local Notation bb := (Lighthouse.b sigma d0 pt).
Local Notation rejected := (Lighthouse.rejected sigma alpha d0 pt).
Local Notation test_cost := (Lighthouse.test_cost sigma alpha d0 pt).
Local Notation pass := (Lighthouse.pass sigma alpha d0 pt).
Local Notation runs := (Lighthouse.runs sigma alpha d0 pt).

Fixpoint exec A (p : prog A) d : A * D * seq (nat * percept) := match p with
  | Ret x => (x, d, [::])
  | Go k f => let: (x, z, t) := exec (f (obs (mv k d))) (mv k d) in (x, z, (k, obs (mv k d)) :: t) end.
(* run from dart d the program gives x, at dart z, after n traversals *)
Definition ends A (p : prog A) d x z n := exists t, exec p d = (x, z, t) /\ size t = n.
Lemma ends_ret A (x : A) d : ends (Ret x) d x d 0.
Proof. by exists [::]. Qed.
Lemma ends_go A k (f : percept -> prog A) d x z n :
  ends (f (obs (mv k d))) (mv k d) x z n -> ends (Go k f) d x z n.+1.
Proof. by case=> t [E <-]; exists ((k, obs (mv k d)) :: t); rewrite /= E. Qed.
Lemma ends_bind A B (p : prog A) (f : A -> prog B) d x z n y z' n' :
  ends p d x z n -> ends (f x) z y z' n' -> ends (bind p f) d y z' (n + n').
Proof.
case=> t [E <-] F; elim: p d t E => [x'|k g IH] d t /=; first by case=> -> -> <-.
case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1; rewrite addSn; apply: ends_go.
exact: (IH _ _ _ E).
Qed.

Definition due c d x := iter c sigma d = x.            (* a free turn by c is still due *)
Lemma mv_due c d x k : due c d x -> mv (c + k) d = mv k x.
Proof. by move=> <-; rewrite /Lighthouse.mv addnC iterD. Qed.
Lemma walkto_ok w k c d x : due c d x ->
  ends (walkto w k c) d (obs (mv k (run w x))) (mv k (run w x)) (size w).+1.
Proof.
elim: w c d x => [|j w IH] c d x du /=; apply: ends_go; rewrite (mv_due _ du); first exact: ends_ret.
exact: IH.
Qed.
Lemma opp_ok k z : due (opp (order sigma z) k) (iter k sigma z) z.
Proof.
rewrite /due /opp -(iter_mod sigma_inj k) -iterD subnK ?iter_order //.
by rewrite ltnW // ltn_mod order_gt0.
Qed.
Fixpoint trail (done : seq (nat * nat)) y x :=
  if done is q :: done' then exists z, [/\ y = mv q.1 z, q.2 = order sigma z & trail done' z x] else y = x.
Lemma back_ok done c d y x : due c d y -> trail done y x ->
  exists c' z, ends (back done c) d c' z (size done) /\ due c' z x.
Proof.
elim: done c d y => [|[k n] done IH] c d y du /=; first by move=> <-; exists c, d; split=> //; exact: ends_ret.
case=> z [Y N T]; have E : mv c d = iter k sigma z by rewrite -[c]addn0 (mv_due 0 du) Y /Lighthouse.mv /= alphaK.
have [|c' [z' [A B]]] := IH (opp n k) (mv c d) z _ T; first by rewrite E N; exact: opp_ok.
by exists c', z'; split=> //; exact: ends_go.
Qed.
Lemma check_ok w exp done c d y x : due c d y -> size exp = (size w).+1 -> trail done y x ->
  exists done' c' z y', let j := find (fun q => q.1 != q.2) (zip (trace w y) exp) in
  if trace w y == exp then ends (check w exp done c (obs y)) d (true, done', c') z (size w) /\ due c' z (run w y)
  else [/\ ends (check w exp done c (obs y)) d (false, done', c') z j, due c' z y', trail done' y' x & size done' = size done + j].
Proof.
elim: w exp done c d y => [|k w IH] [|e0 exp] done c d y du //= [sz] T.
  case: exp sz => // _; exists done, c, d, y; rewrite eqseq_cons eqxx andbT.
  by case: (obs y =P e0) => E /=; rewrite ?addn0; split=> //; exact: ends_ret.
rewrite eqseq_cons; case: (obs y =P e0) => E /=; last first.
  by exists done, c, d, y; split; rewrite ?addn0 //; exact: ends_ret.
have T' : trail ((k, (obs y).1) :: done) (mv k y) x by exists y.
have [done' [c' [z [y' H]]]] := IH exp _ 0 (mv k y) (mv k y) (erefl _) sz T'.
exists done', c', z, y'; move: H; case: ifP => _ /=.
  by case=> A B; split=> //; apply: ends_go; rewrite (mv_due k du).
by case=> A B C F; split=> //; [apply: ends_go; rewrite (mv_due k du) | rewrite F addSnnS].
Qed.
Definition hyp S e h := [/\ isopen S h, h != e, srun S (route S h 0).1 h = Some (route S h 0).2,
  (route S h 0).2.1 = 0 & size (route S h 0).1 < size (degs S)].
Lemma tests_ok S e x hs c d : (forall h, h \in hs -> hyp S e h) -> uniq hs -> due c d x ->
  exists ts, [/\ rejected S e x ts, {subset unzip1 ts <= hs}, uniq (unzip1 ts) &
    (unzip1 ts = hs /\ exists c' z, ends (tests S bb (obs x) hs c) d (None, c') z (test_cost S x ts) /\ due c' z x)
    \/ exists h c' z, let wf := route S h 0 in [/\ h \in hs, uniq (h :: unzip1 ts),
      trace wf.1 x = strace bb S wf.1 h,
      ends (tests S bb (obs x) hs c) d (Some (h, wf.2), c') z (test_cost S x ts + size wf.1) & due c' z (run wf.1 x)]].
Proof.
elim: hs c d => [|h hs IH] c d H U du.
  exists [::]; split=> //; left; split=> //; exists c, d; rewrite /Lighthouse.test_cost big_nil.
  by split=> //; exact: ends_ret.
have [oh he R f0 sw] := H h (mem_head _ _); have /andP[hU U'] := U.
set w := (route S h 0).1 in R sw; set f := (route S h 0).2 in R f0.
have sz := size_strace sigma d0 pt R.
have [done [c' [z [y' CK]]]] := check_ok du sz (erefl : trail [::] x x).
move: CK => /=; case: ifP => [/eqP V [A B]|/eqP V [A B T F]].
  exists [::]; split=> //; right; exists h, c', z; rewrite -/w -/f; split=> //; first exact: mem_head.
  rewrite /Lighthouse.test_cost big_nil add0n -[size w]addn0; apply: (ends_bind A); exact: ends_ret.
have [c2 [z2 [A2 B2]]] := back_ok B T; rewrite /= add0n in F; rewrite -F in A.
have [|ts [Rj Sb Ut HH]] := IH c2 z2 _ U' B2; first by move=> h' m; apply: H; rewrite inE m orbT.
have tc : test_cost S x ((h, w) :: ts) = size done + size done + test_cost S x ts.
  by rewrite /Lighthouse.test_cost big_cons /walked /= addnn -mul2n F.
exists ((h, w) :: ts); split=> /=.
- move=> h' w'; rewrite inE => /orP[/eqP[-> ->]|m]; last exact: Rj.
  by split=> //; exists f.
- by move=> q; rewrite !inE => /orP[->//|/Sb->]; rewrite orbT.
- by rewrite Ut andbT; apply: contra hU; exact: Sb.
case: HH => [[<- [c3 [z3 [A3 B3]]]]|[g [c3 [z3 [mg Ug Vg A3 B3]]]]]; [left|right].
  split=> //; exists c3, z3; split=> //; rewrite tc -addnA /=.
  apply: (ends_bind A); exact: (ends_bind A2 A3).
exists g, c3, z3; split=> //; first by rewrite inE mg orbT.
  move: Ug => /= /andP[gt _]; rewrite inE negb_or gt Ut !andbT; apply/andP; split.
    by apply/eqP=> gh; move: hU; rewrite -gh mg.
  by apply: contra hU; exact: Sb.
rewrite tc -!addnA /=; apply: (ends_bind A); exact: (ends_bind A2 A3).
Qed.

(* one pass of the program is a pass of the relation, step for step *)
Theorem explore_dart_ok k e d p : ok sigma alpha d0 (Conf (kS k) (khere k) p) -> isopen (kS k) e -> kb k = bb ->
  due (kc k) d p -> exists k' z n p', [/\ ends (explore_dart k e) d k' z n, kb k' = bb,
    pass e (Conf (kS k) (khere k) p) n (Conf (kS k') (khere k') p') & due (kc k') z p'].
Proof.
case: k => S b h c /= [r [/= I kh ph Rc]] oe -> du; have [ke _] := andP oe.
have Hl x y : link S x = Some y -> known S y by move=> L; have [_ ? _ _] := inv_link I (linkP L).
have [R g1 sw0] : let wf := route S h e.1 in [/\ srun S wf.1 h = Some wf.2, wf.2.1 = e.1 & size wf.1 < size (degs S)].
  apply: routeP => //; have [[w [f [Rw f0]]] _] := Rc h kh; have [_ A] := Rc e ke.
  by have [kf _] := srun_phi sigma_inj I kh Rw; exact: (rch_trans Rw (rch_anchor A kf f0)).
rewrite /explore_dart /=; set w0 := (route S h e.1).1 in R sw0 *; set g := (route S h e.1).2 in R g1 *.
have [kg _] := srun_phi sigma_inj I kh R; have T := turn_to kg ke g1; set k := (_ + _) in T *.
have W := walkto_ok w0 k du; set x := mv k (run w0 p) in W.
set hs := [seq h0 <- opens S | h0 != e].
have Hh h' : h' \in hs -> hyp S e h'.
  rewrite mem_filter mem_opens => /andP[he oh]; have [kh' _] := andP oh.
  by have [Ra Rb Rd] := routeP kh' Hl (proj1 (Rc h' kh')).
have Uh : uniq hs by rewrite !filter_uniq ?undup_uniq.
have [ts [Rj Sb Ut HH]] := tests_ok Hh Uh (erefl (iter 0 sigma x)).
case: HH => [[E [c' [z [A B]]]]|[h' [c' [z [mh Uh' V A B]]]]].
  exists (finish (K S bb h c) e (obs x) (None, c')), z; do 2 eexists; split; last exact: B.
  - apply: (ends_bind W); apply: (ends_bind A); exact: ends_ret.
  - by [].
  - rewrite addn0 -[_.+1]addn1; apply: (@PassVertex _ sigma alpha d0 pt e S h p w0 g k ts oe R T sw0 Rj Ut) => h' oh he.
    by rewrite E mem_filter he mem_opens.
have [oh he R' f0 sw] := Hh h' mh.
exists (finish (K S bb h c) e (obs x) (Some (h', (route S h' 0).2), c')), z; do 2 eexists; split; last exact: B.
- apply: (ends_bind W); apply: (ends_bind A); exact: ends_ret.
- by [].
- rewrite addn0 addnA -[_.+1]addn1.
  exact: (@PassLoop _ sigma alpha d0 pt e S h p w0 g k h' _ _ ts oe R T sw0 Rj Uh' oh he R' f0 sw V).
Qed.

(* ---- 3. The whole run ---- *)
Local Notation mrun := (Algorithm.mrun mv obs).
Lemma mrun_settle fuel p q d : settle p = settle q -> mrun fuel p d = mrun fuel q d.
Proof. by case: fuel => [|fuel] /= ->. Qed.
Lemma settle_open k e U : opens (kS k) = e :: U -> settle (Ret k) = settle (explore_dart k e).
Proof. by move=> /= ->; rewrite /explore_dart; case: (route _ _ _).1. Qed.
Lemma mrun_exec p d s z t fuel t' e z' : exec p d = (s, z, t) -> mrun fuel (Ret s) z = (t', Some e, z') ->
  mrun (size t + fuel) p d = (t ++ t', Some e, z').
Proof.
move=> E F; elim: p d t E => [x|k g IH] d t; first by case=> -> -> <-.
rewrite [exec _ _]/=; case E: (exec _ _) => [[x1 z1] t1] [X Z <-]; subst x1 z1.
by rewrite [size _]/= addSn [mrun _ _ _]/= (IH _ _ _ E).
Qed.
Lemma runs_ok n C c : runs n C c -> ok sigma alpha d0 c.
Proof. by elim=> [|m C0 e c1 C1 c2 _ O P]; [exact: ok_start | exact: (pass_ok sigma_inj alphaK alphaN pt0 O P)]. Qed.
Lemma rounds k d p n C : runs n C (Conf (kS k) (khere k) p) -> kb k = bb -> due (kc k) d p ->
  exists t k' d' p' n', [/\ mrun (size t) (Ret k) d = (t, Some (estimate k'), d'),
    runs n' (C + size t) (Conf (kS k') (khere k') p'), due (kc k') d' p' & opens (kS k') = [::]].
Proof.
have [N] := ubnP (#|D| - n.*2); elim: N k d p n C => // N IH k d p n C lN Rn kbb du.
case U: (opens (kS k)) => [|e U'].
  exists [::], k, d, p, n; rewrite addn0; split=> //.
  by rewrite /= U.
have oe : isopen (kS k) e by rewrite -mem_opens U mem_head.
have [k1 [z [n1 [p1 [[t1 [E1 s1]] b1 P1 du1]]]]] := explore_dart_ok (runs_ok Rn) oe kbb du.
have R1 := RunsS Rn P1; have [le _ _ _] := algorithm1 sigma_inj alphaK alphaN conn pt0 R1.
have [|t [k' [d' [p' [n' [A B F G]]]]]] := IH k1 z p1 n.+1 (C + n1) _ R1 b1 du1.
  rewrite ltnS in lN; apply: leq_trans lN; rewrite doubleS in le *; apply: ltn_sub2l; last by [].
  exact: leq_trans le.
exists (t1 ++ t), k', d', p', n'; split=> //; last by rewrite size_cat s1 addnA.
by rewrite size_cat (mrun_settle _ _ (settle_open U)); exact: (mrun_exec E1 A).
Qed.

(* ---- 4. The estimate is the world, seen from where the robot is ---- *)
Definition wm := @Rooted.Gmap D (fun _ => true) sigma alpha d0.
Lemma mem_darts S e : (e \in darts S) = known S e.
Proof.
apply/flatten_mapP/andP=> [[v]|[l1 l2]].
  by rewrite mem_iota /= => lv /mapP[i]; rewrite mem_iota /= => li ->.
by exists e.1; rewrite ?mem_iota //; apply/mapP; exists e.2; rewrite ?mem_iota // -surjective_pairing.
Qed.
Lemma darts_uniq S : uniq (darts S).
Proof.
rewrite /darts; elim: (iota 0 _) (iota_uniq 0 (size (degs S))) => //= v s IH /andP[vs U].
rewrite cat_uniq IH // map_inj_uniq ?iota_uniq // => [|i j [] //]; rewrite andbT /=.
apply/hasPn=> e /flatten_mapP[v' v's /mapP[i _ ->]]; apply/mapP=> -[j _ [E _]].
by rewrite -E v's in vs.
Qed.
Lemma estimate_right k r d p : inv sigma alpha d0 (kS k) r -> iso sigma alpha d0 (kS k) r ->
  known (kS k) (khere k) -> p = phi sigma d0 r (khere k) -> due (kc k) d p ->
  Rooted.valid (estimate k) /\ Rooted.riso (Rooted.den (estimate k)) (Rooted.reroot wm d).
Proof.
case: k => S b h c /= I [sur inj trn lnk _] kh -> du; set M := Rooted.den _.
pose nt i := nth (0, 0) (darts S) i; pose f i := phi sigma d0 r (nt i).
have dM i : Rooted.dom M i = (i < size (darts S)) by rewrite /= size_map.
have kn i : i < size (darts S) -> known S (nt i) by move=> li; rewrite -mem_darts; exact: mem_nth.
have ntK e : known S e -> (num S e < size (darts S)) /\ nt (num S e) = e.
  by move=> ke; rewrite /num index_mem mem_darts ke /nt nth_index // mem_darts.
have fi i j : i < size (darts S) -> j < size (darts S) -> f i = f j -> i = j.
  move=> li lj /(inj _ _ (kn _ li) (kn _ lj)) /eqP; rewrite /nt nth_uniq ?darts_uniq //.
  by move/eqP.
have fs i : i < size (darts S) -> Rooted.sg M i < size (darts S) /\ f (Rooted.sg M i) = sigma (f i).
  move=> li; rewrite /= (nth_map (0, 0)) //; have [l E] := ntK _ (known_turn 1 (kn _ li)).
  by split=> //; rewrite /f E trn //; exact: kn.
have fa i : i < size (darts S) -> Rooted.al M i < size (darts S) /\ f (Rooted.al M i) = alpha (f i).
  move=> li; rewrite /= (nth_map (0, 0)) //; have [g [-> kg E]] := lnk _ (kn _ li).
  by have [l E'] := ntK _ kg; split=> //; rewrite /f E' E.
have [l0 e0] := ntK _ (known_turn (opp (deg S h.1) c) kh).
have rt0 : f (Rooted.rt M) = d.
  rewrite /f /= e0 (phi_turn sigma_inj I) // -du; have [l1 _] := knownP I kh.
  rewrite (deg_r I l1) -(order_conn sigma_inj (phi_conn sigma d0 r h)) -du.
  rewrite (order_conn sigma_inj (fconnect_iter sigma c d)); exact: opp_ok.
split.
  apply: Rooted.validI; last by rewrite /= !size_map.
  split=> [|i|i|i j|i|i]; rewrite ?dM //.
  - by case/fs.
  - by case/fa.
  - move=> li lj E; apply: fi => //; apply: sigma_inj.
    by have [_ <-] := fs _ li; have [_ <-] := fs _ lj; rewrite E.
  - move=> li; have [l1 E1] := fa _ li; have [l2 E2] := fa _ l1.
    by apply: fi => //; rewrite E2 E1 alphaK.
  - move=> li E; have [_ E1] := fa _ li; have := alphaN (f i); by rewrite -E1 E eqxx.
pose g x := find (fun e => phi sigma d0 r e == x) (darts S).
have gP x : g x < size (darts S) /\ f (g x) = x.
  have hx : has (fun e => phi sigma d0 r e == x) (darts S).
    by have [e ke <-] := sur x; apply/hasP; exists e; rewrite ?mem_darts.
  by split; [rewrite /g -has_find | apply/eqP; exact: (nth_find (0, 0) hx)].
exists f, g; split.
- move=> i; rewrite dM => li; split=> //.
  + by have [lg E] := gP (f i); exact: fi.
  + by have [] := fs _ li.
  + by have [] := fa _ li.
- by move=> x _; rewrite dM; exact: gP.
- exact: rt0.
Qed.

(* ---- 5. The explorer, as a function of the percepts, in every world ---- *)
Lemma explore_mrun fuel o h d :
  @Rooted.explore _ _ algorithm1X wm obs fuel (o :: h) d = mrun fuel (foldl update (Ret (first_state o)) h) d.
Proof.
elim: fuel h d => [|fl IH] h d /=; rewrite /act; case E: (settle _) => [e|[k f]] //.
rewrite IH.
have -> : foldl update (Ret (first_state o)) (rcons h (obs (mv k d))) = f (obs (mv k d)).
  by rewrite -cats1 foldl_cat /= /update E.
by [].
Qed.
(* the paper's (1) + (2) *)
Definition paper n m := \sum_(1 <= s < n) (s + 2 * s.-1 * (m.*2 - s.-1.*2)) +
  \sum_(0 <= i < m - n.-1) (n + 2 * n.-1 * (m.*2 - (i + n.-1).*2)).
(* with any budget of at least (1) + (2) traversals it stops, within (1) + (2), with the world as seen from its true dart *)
Theorem algorithm1_explorer : let m := #|D|./2 in m.*2 = #|D| /\
  forall fuel, paper (nv sigma) m <= fuel -> exists t e z, [/\
    @Rooted.episode _ _ algorithm1X wm obs fuel = (t, Some e, z),
    Rooted.valid e, Rooted.riso (Rooted.den e) (Rooted.reroot wm z) & size t <= paper (nv sigma) m].
Proof.
pose k0 := first_state (obs d0).
have R0 : runs 0 0 (Conf (kS k0) (khere k0) d0) by exact: Runs0.
have b0 : kb k0 = bb by rewrite /k0 /= /bear pt0.
have [t [k [d [p [n [A B F G]]]]]] := rounds R0 b0 (erefl : due 0 d0 d0).
have nop e : ~~ isopen (kS k) e by rewrite -mem_opens G.
have [r [/= I kh ph _]] := runs_ok B; have X := exit_iso sigma_inj conn I nop.
have [W Is] := estimate_right I X kh ph F.
have [E Cb] := algorithm1_cost sigma_inj alphaK alphaN conn pt0 B nop.
rewrite -E doubleK; split=> // fuel lf; rewrite add0n in Cb; have le := leq_trans Cb lf.
exists t, (estimate k), d; split=> //; rewrite -(subnKC le) /Rooted.episode.
by apply: (@Rooted.explore_more _ _ algorithm1X wm obs); rewrite explore_mrun.
Qed.
Corollary algorithm1_right : @Rooted.right _ _ Rooted.den algorithm1X wm obs.
Proof.
have [_ /(_ _ (leqnn _)) [t [e [z [A B C _]]]]] := algorithm1_explorer.
by exists (paper (nv sigma) #|D|./2), t, e, z; split=> //; exact: Rooted.validP.
Qed.
End InWorld.
(* hence a directional lighthouse is never ambiguous: worlds that no motion tells apart are the same rooted map *)
Corollary directional_unambiguous (D1 D2 : finType) (s1 a1 : D1 -> D1) (s2 a2 : D2 -> D2) d1 p1 d2 p2 (R : D1 -> D2 -> Prop) :
  injective s1 -> involutive a1 -> (forall d, a1 d != d) -> (forall x y, connect (adj s1 a1) x y) -> fconnect s1 d1 p1 ->
  injective s2 -> involutive a2 -> (forall d, a2 d != d) -> (forall x y, connect (adj s2 a2) x y) -> fconnect s2 d2 p2 ->
  (forall x y, R x y -> Lighthouse.obs s1 p1 x = Lighthouse.obs s2 p2 y) -> (forall x y, R x y -> R (s1 x) (s2 y)) ->
  (forall x y, R x y -> R (a1 x) (a2 y)) -> R d1 d2 -> Rooted.riso (wm s1 a1 d1) (wm s2 a2 d2).
Proof.
move=> i1 k1 n1 c1 f1 i2 k2 n2 c2 f2 Ro Rs Ra R0.
have wfm (D : finType) (s a : D -> D) d : injective s -> involutive a -> (forall d, a d != d) -> Rooted.wf (wm s a d).
  by move=> i k n; split=> //= [x y _ _ /i //|x _ E]; move: (n x); rewrite E eqxx.
apply: (@Rooted.twins_impossible _ _ Rooted.den algorithm1X (wm s1 a1 d1) (wm s2 a2 d2) (Lighthouse.obs s1 p1) (Lighthouse.obs s2 p2) R) => //;
  by [exact: wfm | exact: algorithm1_right].
Qed.

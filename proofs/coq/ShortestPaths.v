(* ---------------------------------------------------------------------------------------------
   The breadth-first path is a shortest one, so `nearest` picks the nearest dart.
                                                                        Algorithm 1, lines 3, 4, 9

     layered i T          the lengths in the list T of branches never fall, and while the i-th branch
                          is looked at none is longer than it by more than one.
     near i T             each neighbour of the first i vertices has a branch at most one step longer.
     route_shortest       no path in S from a to a vertex v is shorter than route S a v.
     nearest_is_nearest   the dart that `nearest` explores has the least distance of all open darts.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model PartialMaps Paths Routes Algorithm Policies.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Shortest.
Variables (S : partial_map) (a : dart).
Hypothesis ka : known S a.
Hypothesis Hl : forall x y, partner S x = Some y -> known S y.
Local Notation len T x := (size (nth no_branch T x).2.1).

Lemma visits_length w c ks (T : seq branch) : exists X,
  foldl (visit S w c) T ks = T ++ X /\ forall t, t \in X -> size t.2.1 = (size w).+1.
Proof.
elim: ks T => [|k ks IH] T /=; first by exists [::]; rewrite cats0.
rewrite {2}/visit; case: (partner S _) => [g|]; last exact: IH.
case: ifP => _; first exact: IH.
have [X [-> H]] := IH (rcons T (g.1, (rcons w k, g))).
exists ((g.1, (rcons w k, g)) :: X); rewrite cat_rcons; split=> // t.
by rewrite inE => /orP[/eqP->|/H //]; rewrite /= size_rcons.
Qed.

Definition layered i T :=
  (forall x y, x <= y -> y < size T -> len T x <= len T y) /\
  (i < size T -> forall x, x < size T -> len T x <= (len T i).+1).
Definition near i (T : seq branch) := forall j, j < i -> forall p g,
  let c := (nth no_branch T j).2.2 in
  p < degree_in S c.1 -> partner S (c.1, p) = Some g ->
  exists2 x, x < size T & (nth no_branch T x).1 = g.1 /\ len T x <= (len T j).+1.

Lemma grow_near fuel i T : good S a T -> i <= size T -> size (degrees S) <= fuel + i ->
  layered i T -> near i T ->
  let T' := grow S fuel i T in near (size T') T' /\ exists Y, T' = T ++ Y.
Proof.
elim: fuel i T => [|fl IH] i T G li ns La Ne /=.
  have E : i = size T by apply/eqP; rewrite eqn_leq li /=; exact: leq_trans (good_size G) ns.
  by rewrite -E; split=> //; exists [::]; rewrite cats0.
case: ifP => [lt|/negbT]; last first.
  rewrite -leqNgt => le; have E : i = size T by apply/eqP; rewrite eqn_leq li.
  by rewrite -E; split=> //; exists [::]; rewrite cats0.
set t := (nth no_branch T i).2; have [U H] := G; have [R e1 kc sw] := H i lt.
have [X [E GX HX]] := visits Hl (round S t.2) R (leq_ltn_trans sw lt) G.
have [X' [E' LX']] := visits_length t.1 t.2 (round S t.2) T.
have LX : forall u, u \in X -> size u.2.1 = (size t.1).+1.
  suff -> : X = X' by [].
  by have := congr1 (drop (size T)) E'; rewrite -/t in E; rewrite E !drop_size_cat.
rewrite -/t in E; rewrite E.
have [So Fa] := La.
have inX x : size T <= x -> x < size (T ++ X) -> len (T ++ X) x = (len T i).+1.
  move=> le; rewrite nth_cat [x < size T]ltnNge le size_cat /= => lx; rewrite LX // mem_nth //.
  by rewrite -(ltn_add2l (size T)) subnKC.
have inT x : x < size T -> len (T ++ X) x = len T x by move=> lx; rewrite nth_cat lx.
have all_le x : x < size (T ++ X) -> len (T ++ X) x <= (len T i).+1.
  by case: (ltnP x (size T)) => [lx _|le lx]; [rewrite inT // Fa | rewrite inX].
have So' x y : x <= y -> y < size (T ++ X) -> len (T ++ X) x <= len (T ++ X) y.
  move=> xy ly; case: (ltnP y (size T)) => [ly'|ge].
    by rewrite !inT ?So // (leq_ltn_trans xy).
  by rewrite (inX y) // all_le // (leq_ltn_trans xy).
have [||||N [Y EY]] := IH i.+1 (T ++ X) GX.
- by rewrite size_cat ltn_addr.
- by rewrite addnS -addSn.
- split=> // li1 x lx; apply: leq_trans (all_le x lx) _; rewrite ltnS -(inT i) //.
  exact: So'.
- move=> j; rewrite ltnS leq_eqVlt => /orP[/eqP->|lj] p g; rewrite /= nth_cat.
    rewrite lt -/t => lp L; have [lc _] := andP kc.
    have m : g.1 \in unzip1 (T ++ X).
      apply: (HX (degree_in S t.2.1 - t.2.2 + p)); first by rewrite map_f ?mem_iota.
      by rewrite (@turn_to S t.2 (t.2.1, p)) //; apply/andP.
    have lx : index g.1 (unzip1 (T ++ X)) < size (T ++ X) by rewrite -(size_map fst) index_mem.
    exists (index g.1 (unzip1 (T ++ X))) => //; split; last exact: all_le.
    by rewrite -(nth_map no_branch 0 fst) // nth_index.
  rewrite (ltn_trans lj lt) => lp L; have [x lx [x1 xl]] := Ne j lj p g lp L.
  by exists x; [rewrite size_cat ltn_addr | rewrite nth_cat lx; split].
by split=> //; exists (X ++ Y); rewrite EY catA.
Qed.

Lemma follow_rcons w k e :
  follow S (rcons w k) e = if follow S w e is Some f then partner S (turn S k f) else None.
Proof.
elim: w e => [|j w IH] e /=; first by case: (partner S _).
by case: (partner S _) => [g|].
Qed.

Lemma follow_known w f : follow S w a = Some f -> known S f.
Proof.
elim: w a ka f => [|k w IH] e ke f /=; first by case=> <-.
by case L: (partner S _) => [g|] //; apply: IH; exact: (Hl L).
Qed.

Theorem route_shortest w f : follow S w a = Some f -> size (route S a f.1).1 <= size w.
Proof.
pose T0 : seq branch := [:: (a.1, ([::], a))].
have G0 : good S a T0 by split=> // -[|j].
have La : layered 0 T0 by split=> [[|x] [|y]|_ [|x]].
have Ne : near 0 T0 by [].
have [N [Y EY]] := @grow_near (size (degrees S)) 0 T0 G0 isT (leq_addr _ _) La Ne.
have [|||G _ _] := @growP S a Hl (size (degrees S)) 0 T0 G0; rewrite ?addn0 //.
rewrite -/(tree S a) in N EY G; set T := tree S a in N EY G.
move=> R; suff [x lx [x1 xl]] : exists2 x, x < size T & (nth no_branch T x).1 = f.1 /\ len T x <= size w.
  have [U _] := G; rewrite /route -/T -x1 -(nth_map no_branch 0 fst) // index_uniq ?size_map //.
elim/last_ind: w f R => [|w k IH] f; first by case=> <-; exists 0; rewrite EY.
rewrite follow_rcons; case F: (follow S w a) => [e|] // L.
have [x lx [x1 xl]] := IH e F; have ke := follow_known F.
have [_ H] := G; have [_ c1 _ _] := H x lx.
have de : 0 < degree_in S e.1 by case/andP: ke => _; case: (degree_in S _).
have ce : (nth no_branch T x).2.2.1 = e.1 by rewrite c1.
have [||y ly [y1 yl]] := N x lx ((e.2 + k) %% degree_in S e.1) f; rewrite ?ce ?ltn_mod //.
by exists y => //; split=> //; rewrite size_rcons; exact: leq_trans yl _.
Qed.
End Shortest.

Lemma closest_min k (U : seq dart) e :
  [/\ closest k e U \in e :: U & forall f, f \in e :: U -> distance k (closest k e U) <= distance k f].
Proof.
elim: U e => [|f U IH] e /=; first by split=> [|g]; rewrite ?inE // => /eqP->.
have [M L] := IH (if distance k f < distance k e then f else e).
split.
  by move: M; rewrite !inE; case: ifP => _ /orP[->|->]; rewrite ?orbT.
move=> g; rewrite !inE => /or3P[/eqP->|/eqP->|gU]; last by apply: L; rewrite inE gU orbT.
  apply: leq_trans (L _ (mem_head _ _)) _; case: ifP => //; exact: ltnW.
apply: leq_trans (L _ (mem_head _ _)) _; case: ifP => // /negbT; by rewrite -leqNgt.
Qed.

Theorem nearest_is_nearest k : unexplored k != [::] ->
  next_edge nearest k \in unexplored k /\
  forall e, e \in unexplored k -> distance k (next_edge nearest k) <= distance k e.
Proof.
rewrite /next_edge /=; case: (unexplored k) => // e U _ /=.
have [M L] := closest_min k (e :: U) e.
have {}M : closest k e (e :: U) \in e :: U by move: M; rewrite inE => /orP[/eqP->|//]; exact: mem_head.
rewrite /= in M; rewrite M; split=> // f fU; apply: L; by rewrite inE fU orbT.
Qed.

(* ---------------------------------------------------------------------------------------------
   What an explorer can learn in a corridor: v0 before N near hubs and some far ones.     Section VI

   The far hubs are matched in any way (CorridorWorlds.v); all else is the same in all these worlds.  A robot
   that has been at a far hub learns something at v0 only, and each such return costs 2(N+1) motions.

     logs_after back T q  how many logs there are of T motions, if a return costs `back` motions and the
                          robot has made q motions of one: sums of 'C(T, y) 2^y, y the number of returns.
     logs_counted         so many of these worlds, at most, are told apart with T motions; both from a near
                          hub, where the robot knows its hub_place, and s motions after a far hub.
     same_corridor        different matchings are different maps.
     far_counted          the number of darts that are matched.
     far_pairs_in f e     half of it, in the corridors with F = f+1 far hubs of degree 12F+6+2e.
     corridor_needs       a world that takes an explorer as many motions as there must be for so many logs.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers MassFormula PathWorlds.
From Bounds Require Import Gluings Corridors CorridorWorlds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- How many logs ---- *)
Definition logs_after (back T q : nat) := \sum_(y < ((T + q) %/ back).+1) 'C(T, y) * 2 ^ y.

Lemma logs_after_gt0 back T q : 0 < logs_after back T q.
Proof. by rewrite /logs_after big_ord_recl bin0 addSn. Qed.

Lemma sum_le (k k' : nat) (f f' : nat -> nat) : k <= k' -> (forall y, f y <= f' y) ->
  \sum_(y < k) f y <= \sum_(y < k') f' y.
Proof.
move=> le H; rewrite -(big_mkord predT) -(big_mkord predT f') (big_cat_nat _ _ _ (leq0n k) le) /=.
by apply: leq_trans (leq_addr _ _); apply: leq_sum.
Qed.

Lemma bin_grows T y : 'C(T, y) <= 'C(T.+1, y).
Proof. by case: y => [|y]; rewrite ?bin0 // binS leq_addr. Qed.

Lemma logs_after_le back T T' q q' : T <= T' -> T + q <= T' + q' ->
  logs_after back T q <= logs_after back T' q'.
Proof.
move=> le le'; apply: (@sum_le _ _ (fun y => 'C(T, y) * 2 ^ y) (fun y => 'C(T', y) * 2 ^ y)) => [|y].
  by rewrite ltnS leq_div2r.
rewrite leq_mul2r; apply/orP; right; rewrite -(subnK le).
by elim: (T' - T) => // j IH; exact: leq_trans IH (bin_grows _ _).
Qed.

(* a motion after which v0 is entered, by either dart, or not *)
Lemma logs_after_return back T : 0 < back ->
  logs_after back T back + (logs_after back T 0 + logs_after back T 0) <= logs_after back T.+1 back.-1.
Proof.
move=> b0; rewrite addnn -mul2n /logs_after addn0 addSn -addnS prednK // divnDr ?dvdnn // divnn b0 addn1.
move: (T %/ back) => Y; rewrite big_distrr big_ord_recl [X in _ <= X]big_ord_recl /= !bin0 -addnA leq_add2l.
rewrite -big_split /=; apply: eq_leq; apply: eq_bigr => y _; rewrite /bump /= !add1n binS mulnDl expnS.
by congr (_ + _); rewrite mulnCA.
Qed.

Section Logs.
Variables (N h r : nat) (out : 'I_h.+1 -> bool -> 'I_r.+1).
Hypotheses (L : layout out) (Nh : N <= h).
Local Notation dart := (bool + 'I_h.+1 * 'I_r.+1)%type.
Variable g : {ffun dart -> dart}.
Hypothesis near : near_gluing N out g.
Local Notation matching := (far_matching N out).
Local Notation world := (corridor_world L near).
Local Notation worlds := (fun a : matching => rooted (@start (world a))).
Local Notation senses := (fun a : matching => @percept_of (world a)).
Local Notation rail_end := (rail_end out).
Implicit Types (a : matching) (x y : dart).

(* ---- What is sensed ---- *)
Variable a0 : matching.
Definition percept_home (b : bool) : percept := senses a0 (inl b).
Definition percept_away : percept := (r.+1, None).

Lemma senses_home a b : senses a (inl b) = percept_home b.
Proof. by []. Qed.

Lemma hub_home x : hub x = 0 -> exists b, x = inl b.
Proof. by case: x => [b|[i p]] // _; exists b. Qed.

Lemma degree_away a (x : world a) : 0 < hub x -> degree x = r.+1.
Proof.
case: x => [//|[i p]] _; apply: order_least => //; first exact: corridor_sigma_inj.
  by rewrite corridor_turn after_full.
move=> j /andP[j0 lj]; rewrite corridor_turn => -[/(congr1 val)]; rewrite after_turn => E.
have /eqP : p + j = p + 0 %[mod r.+1] by rewrite addn0 E modn_small.
by rewrite eqn_modDl mod0n modn_small // eqn0Ngt j0.
Qed.

Lemma senses_away a (x : world a) : 0 < hub x -> senses a x = percept_away.
Proof.
move=> hx; rewrite /percept_of degree_away // /bearing /at_same_vertex hub_fconnect.
by rewrite (gtn_eqF hx).
Qed.

Lemma home_bearing b : exists j, (percept_home b).2 = Some j.
Proof. by rewrite /percept_home /percept_of /= /bearing /at_same_vertex hub_fconnect eqxx; eexists. Qed.

Lemma home_not_away b : percept_home b <> percept_away.
Proof. by have [j e] := home_bearing b; move=> s; rewrite s in e. Qed.

Lemma home_percept_inj : injective percept_home.
Proof.
move=> b b' e; have [j e1] := home_bearing b; have e2 : (percept_home b').2 = Some j by rewrite -e.
by have [] : inl b = inl b' :> world a0 by exact: bearing_inj e1 e2.
Qed.

(* ---- A step ---- *)
Lemma motion_worlds a k x : motion_in (worlds a) k x = corridor_alpha g a (iter k (@corridor_sigma h r) x).
Proof. by []. Qed.

Lemma hub_turns k x : hub (iter k (@corridor_sigma h r) x) = hub x.
Proof. by apply/esym/eqP; rewrite -hub_fconnect fconnect_iter. Qed.

Lemma rail_step q : hub (rail_end q) <= (hub (rail_end (q.1, ~~ q.2))).+1.
Proof.
case: q => [[i b] []] /=; case: ifP => [/eqP->|/negbT i0] //=; have j0 : 0 < i by rewrite lt0n.
  by rewrite inordK ?prednK //; exact: ltnW.
rewrite inordK ?prednK //; first by rewrite ltnW // ltnW.
exact: ltnW.
Qed.

(* at v0 and at near hubs the matching of the far hubs plays no part *)
Lemma near_motion a a' k x : hub x <= N -> motion_in (worlds a) k x = motion_in (worlds a') k x.
Proof.
move=> hx; rewrite !motion_worlds /corridor_alpha; case: ifP => // _.
by rewrite ltnNge hub_turns hx.
Qed.

Lemma near_step a k x : hub x <= N -> hub (motion_in (worlds a) k x) <= (hub x).+1.
Proof.
move=> hx; rewrite motion_worlds -(hub_turns k x) in hx *; move: (iter _ _ _) hx => {}x hx.
case: (three_kinds N out x) => [[q ->]|xn|xf].
- by rewrite alpha_rail //; have := rail_step (q.1, ~~ q.2); rewrite /= negbK; case: (q).
- by have [-> _ ->] := alpha_near near a xn.
by move: xf; rewrite inE ltnNge hx andbF.
Qed.

Lemma any_step a k x s : N.+1 <= hub x + s -> N.+1 <= hub (motion_in (worlds a) k x) + s.+1.
Proof.
rewrite motion_worlds -(hub_turns k x); move: (iter _ _ _) => {}x hx.
case: (three_kinds N out x) => [[q e]|xn|xf].
- rewrite e alpha_rail // addnS -addSn; apply: leq_trans hx _; rewrite e leq_add2r; exact: rail_step.
- by have [-> _ ->] := alpha_near near a xn; rewrite addnS leqW.
have [-> +] := alpha_far g a xf; rewrite inE => /andP[_ l]; exact: leq_trans l (leq_addr _ _).
Qed.

(* ---- The count ---- *)
Variables (E : Type) (X : explorer percept E).
Local Notation told := (logs_differ X worlds senses).
Local Notation back := (2 * N.+1).
Local Notation count := (logs_after back).

Theorem logs_counted T :
  (forall seen (d : forall a, carrier (worlds a)) (A : {set matching}) x, hub x <= N ->
     (forall a, a \in A -> d a = x) -> told T seen d A -> #|A| <= count T (hub x)) /\
  (forall seen (d : forall a, carrier (worlds a)) (A : {set matching}) s,
     (forall a, a \in A -> N.+1 <= hub (d a) + s) -> told T seen d A ->
     #|A| <= count T (N.+1 + minn s N.+1)).
Proof.
elim: T => [|T [known lost]].
  have one seen d A q : told 0 seen d A -> #|A| <= count 0 q.
    by move=> T0; apply: leq_trans (told_by_no_motion T0) (logs_after_gt0 _ _ _).
  by split=> [seen d A x _ _ T0|seen d A s _ T0]; apply: one T0.
split=> seen d A.
  move=> x hx at_x T0; case E0: (X seen) => [k|e]; last first.
    by apply: leq_trans (told_by_stopping E0 T0) (logs_after_gt0 _ _ _).
  pose y : dart := motion_in (worlds a0) k x.
  have to_y a : a \in A -> led worlds k d a = y.
    by move=> aA; rewrite /led at_x //; exact: near_motion.
  have y1 : hub y <= (hub x).+1 by exact: near_step.
  have shows a : a \in A -> senses a (led worlds k d a) = senses a0 y.
    by move=> aA; rewrite to_y.
  have {}T0 := told_on E0 shows T0; case: (leqP (hub y) N) => [hy|hy].
    apply: leq_trans (known _ _ _ _ hy to_y T0) _; apply: logs_after_le; first exact: leqnSn.
    by rewrite addSn -addnS leq_add2l.
  have away a : a \in A -> N.+1 <= hub (led worlds k d a) + 0 by move=> aA; rewrite to_y // addn0.
  apply: leq_trans (lost _ _ _ _ away T0) _; rewrite min0n addn0; apply: logs_after_le; first exact: leqnSn.
  by rewrite addSn -addnS leq_add2l (leq_trans hy y1).
move=> s far T0; case E0: (X seen) => [k|e]; last first.
  by apply: leq_trans (told_by_stopping E0 T0) (logs_after_gt0 _ _ _).
have next a : a \in A -> N.+1 <= hub (led worlds k d a) + s.+1.
  by move=> aA; exact: any_step (far a aA).
case: (ltnP s N) => ls.
  have away a : a \in A -> senses a (led worlds k d a) = percept_away.
    move=> aA; apply: senses_away; have := next a aA; case: posnP => // ->.
    by rewrite add0n ltnNge (leq_trans ls) // leqNgt ltnS ltnn.
  apply: leq_trans (lost _ _ _ _ next (told_on E0 away T0)) _; apply: logs_after_le; first exact: leqnSn.
  rewrite (minn_idPl _) ?(leq_trans ls) // (minn_idPl _) ?(leq_trans (ltnW ls)) //.
  by rewrite !(addSn, addnS).
pose part o := [set a in A | senses a (led worlds k d a) == o].
have at_home b : #|part (percept_home b)| <= count T 0.
  apply: (known (rcons seen (percept_home b)) (led worlds k d) _ (inl b)) => //; last exact: told_step E0 T0.
  move=> a; rewrite inE => /andP[_ /eqP e]; case: (posnP (hub (led worlds k d a))) => [/hub_home[b' e']|hy].
    by rewrite e' senses_home in e; rewrite e' (home_percept_inj e).
  by have := home_not_away (b := b); rewrite -e senses_away.
have out_there : #|part percept_away| <= count T back.
  have next' a : a \in part percept_away -> N.+1 <= hub (led worlds k d a) + s.+1.
    by rewrite inE => /andP[aA _]; exact: next.
  have := lost (rcons seen percept_away) (led worlds k d) _ _ next' (told_step E0 T0 (o := percept_away)).
  by rewrite (minn_idPr _) ?ltnS // addnn mul2n.
have cover : A \subset part percept_away :|: (part (percept_home false) :|: part (percept_home true)).
  apply/subsetP=> a aA; rewrite !inE aA /=.
  case: (posnP (hub (led worlds k d a))) => [/hub_home[b ->]|hy].
    by rewrite senses_home; case: b; rewrite eqxx ?orbT.
  by rewrite (@senses_away a _ hy) eqxx.
apply: leq_trans (subset_leq_card cover) _; apply: leq_trans (leq_card_setU _ _) _.
have returns := leq_trans (leq_card_setU _ _) (leq_add (at_home false) (at_home true)).
apply: leq_trans (leq_add out_there returns) _.
apply: leq_trans (logs_after_return _ _) _ => //; apply: logs_after_le => //.
have -> : back.-1 = N.+1 + N by rewrite mul2n -addnn addnS.
by rewrite leq_add2l leq_add2l leq_min ls leqnSn.
Qed.

(* ---- Different matchings are different maps ---- *)
Lemma same_corridor a a' : same_map (worlds a) (worlds a') -> a = a'.
Proof.
move=> [root' _ [f [f' [Q _ _]]]].
have fs x : f (corridor_sigma x) = corridor_sigma (f x) by have [_ _ e _] := Q x isT; exact: e.
have fa x : f (corridor_alpha g a x) = corridor_alpha g a' (f x) by have [_ _ _ e] := Q x isT; exact: e.
have fr q : f (rail_end (q.1, ~~ q.2)) = corridor_alpha g a' (f (rail_end q)).
  by rewrite -fa alpha_rail.
have r2 := ring_large L.
have home : exists b, f (inl false) = inl b.
  have e1 : f (inl true) = corridor_sigma (f (inl false)) := fs (inl false).
  have : f (inl false) = corridor_sigma (f (inl true)) := fs (inl true).
  rewrite e1; case: (f (inl false)) => [b _|[i p]]; first by exists b.
  case=> /(congr1 val) /esym; rewrite -[after _]/(iter 2 (@after r) p) after_turn => two.
  have /eqP : p + 2 = p + 0 %[mod r.+1] by rewrite addn0 two modn_small.
  by rewrite eqn_modDl mod0n modn_small.
have small (b : bool) : b < r.+1 by case: (b); rewrite // ltnS ltnW.
have f0 : f (inl false) = inl false.
  have [[] e] := home; last by [].
  (* turned by one at v0 means turned by one at the first hub *)
  have e1 : f (inr (ord0, inord 0)) = inr (ord0, inord 1).
    by have := fr (ord0, false, false); rewrite /= e => ->; exact: (alpha_rail L g a' (ord0, true, false)).
  have e2 : f (inr (ord0, inord 1)) = inr (ord0, after (inord 1)).
    have up : inord 1 = after (inord 0) :> 'I_r.+1.
      by apply: val_inj; have := after_turn 1 (inord 0 : 'I_r.+1); rewrite /= => ->;
        rewrite !inordK ?(small true) // modn_small ?(small true).
    by have := fs (inr (ord0, inord 0)); rewrite /= -up e1.
  have := fr (ord0, true, true); rewrite [rail_end _]/= e2.
  have -> : f (inl true) = inl false by rewrite [LHS](fs (inl false)) e.
  move=> e3.
  have e4 := corridor_alphaK L near a' (inr (ord0, after (inord 1))); rewrite -e3 in e4.
  move: e4; rewrite (alpha_rail L g a' (ord0, false, false)) => -[/(congr1 val)].
  have := after_turn 1 (inord 1 : 'I_r.+1); rewrite /= => ->.
  by rewrite !inordK ?(small true) ?(small false) // modn_small.
have fix_hub x y : hub x = hub y -> f x = x -> f y = y.
  move/eqP; rewrite -hub_fconnect => /iter_findex <- fx.
  by elim: (findex _ _ _) => // j IH; rewrite iterS fs IH.
have fid x : f x = x.
  have [n] := ubnP (hub x); elim: n x => // n IH x; rewrite ltnS => lx.
  case E0: (hub x) => [|j]; first exact: fix_hub (inl false) _ _ f0.
  have lj : j < h.+1 by move: E0; case: (x) => [//|[i p]] /= [<-].
  pose q : rail h := (Ordinal lj, false).
  apply: (fix_hub (rail_end (q, true))); first by rewrite E0.
  have low : hub (rail_end (q, false)) < n.
    rewrite /=; case: ifP => [_|/negbT n0] /=; first by rewrite (leq_trans _ lx) ?E0.
    have j0 : 0 < j by rewrite lt0n.
    rewrite inordK; last exact: leq_ltn_trans (leq_pred _) lj.
    by rewrite prednK // (leq_trans _ lx) // E0.
  by have := fr (q, false); rewrite /= (IH _ low) => ->; exact: (alpha_rail L g a' (q, false)).
apply/val_inj/ffunP=> x; case: (boolP (x \in far_free N out)) => xf.
  by have := fa x; rewrite !fid; have [-> _] := alpha_far g a xf; have [-> _] := alpha_far g a' xf.
by have [_ m] := far_pairs a; have [_ m'] := far_pairs a'; move: (m x) (m' x); rewrite xf => /eqP-> /eqP->.
Qed.

Lemma far_counted : #|far_free N out| = (h - N) * (r.+1 - 4) + (r.+1 - 2).
Proof.
rewrite (free_by_hub L (A := fun j => N < j)) // big_mkcond big_ord_recr /= ltnn ltnS Nh.
congr (_ + _); rewrite -big_mkcond /=.
rewrite (eq_bigr (fun=> r.+1 - 4)) => [|i _]; last by rewrite /= ltn_ord.
rewrite -(big_mkord (fun i => N < i.+1) (fun=> r.+1 - 4)) (big_cat_nat _ _ _ (leq0n N) Nh) /=.
rewrite big_nat_cond big_pred0 => [|i]; last by rewrite ltnS [N <= i]leqNgt; case: (i < N).
rewrite add0n big_nat_cond (eq_bigl (fun i => (N <= i < h) && true)) => [|i]; last first.
  by rewrite ltnS andbT; case: (N <= i); rewrite ?andbT ?andbF.
by rewrite -big_nat_cond sum_nat_const_nat.
Qed.

Lemma far_matchings_counted : #|{: matching}| = pairings #|far_free N out|.
Proof. by rewrite card_sig -pairings_counted cardsE. Qed.

Theorem corridor_needs (meaning : E -> rooted_map) :
  (forall a, finds_map meaning X (worlds a) (senses a)) ->
  exists a, forall fuel t e z, episode X (worlds a) (senses a) fuel = (t, Some e, z) ->
  pairings #|far_free N out| <= logs_after back (size t) 0.
Proof.
move=> H; rewrite -far_matchings_counted.
have W a : wellformed (worlds a) by exact: rooted_wellformed.
apply: (one_is_costly W same_corridor H a0 (bound := fun T => count T 0)) => b inj.
rewrite -cardsT.
apply: (proj1 (logs_counted b) [:: percept_home false] (fun=> inl false) setT (inl false)) => //.
by move=> a a' _ _; exact: inj.
Qed.
End Logs.

(* ---- As many matchings as there are ---- *)
Lemma far_matchings_exist N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) :
  N <= h -> ~~ odd r.+1 -> 0 < #|{: far_matching N out}|.
Proof.
move=> Nh ev; rewrite far_matchings_counted far_counted //; apply: pairings_gt0.
have even k : ~~ odd (r.+1 - k.*2).
  case: (leqP k.*2 r.+1) => [le|/ltnW]; first by rewrite oddB // odd_double addbF.
  by rewrite -subn_eq0 => /eqP->.
by rewrite oddD oddM (negbTE (even 2)) andbF (negbTE (even 1)).
Qed.

Theorem corridor_costs N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) g
    (near : near_gluing N out g) : N <= h -> ~~ odd r.+1 ->
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_matching N out,
     finds_map meaning X (rooted (@start (corridor_world L near a)))
       (@percept_of (corridor_world L near a))) ->
  exists a : far_matching N out, forall fuel t e z,
  episode X (rooted (@start (corridor_world L near a))) (@percept_of (corridor_world L near a)) fuel
    = (t, Some e, z) ->
  pairings ((h - N) * (r.+1 - 4) + (r.+1 - 2)) <=
    \sum_(y < (size t %/ (2 * N.+1)).+1) 'C(size t, y) * 2 ^ y.
Proof.
move=> Nh ev E meaning X H; have c := far_counted L Nh.
have := far_matchings_exist L Nh ev.
case/card_gt0P=> a0 _; have [a A] := corridor_needs a0 H; exists a => fuel t e z R.
by rewrite -c; have := A _ _ _ _ R; rewrite /logs_after addn0.
Qed.

Section Sizes.
Variables (N h r : nat) (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out).
Variables (g : {ffun bool + 'I_h.+1 * 'I_r.+1 -> bool + 'I_h.+1 * 'I_r.+1}) (near : near_gluing N out g).
Variable a : far_matching N out.
Local Notation W := (corridor_world L near a).

Lemma corridor_edges : (edges W).*2 = 2 + h.+1 * r.+1.
Proof. by rewrite edges_double card_sum card_bool card_prod !card_ord. Qed.

Lemma corridor_vertices : vertices W = h.+2.
Proof.
have sym := fconnect_sym (@sigma_inj W); pose roots_ : {set W} := [set x in froots (@sigma W)].
have -> : vertices W = #|roots_|.
  by rewrite cardsE /vertices /n_comp_mem; apply: eq_card => x; rewrite !inE andbT.
have small (x : W) : hub x < h.+2 by case: x => [b|[i p]] //=; rewrite ltnS.
pose index (x : W) : 'I_h.+2 := Ordinal (small x).
have inj : {in roots_ &, injective index}.
  move=> x y; rewrite !inE => /eqP rx /eqP ry /(congr1 val) /= /eqP.
  by rewrite -(hub_fconnect x y) -(root_connect sym) rx ry => /eqP.
rewrite -(card_in_imset inj) -[RHS]card_ord; apply: eq_card => j; rewrite [RHS]inE; apply/imsetP.
have [x e] : exists x : W, hub x = j.
  case: j => [[|j] lj] /=; first by exists (inl false).
  by exists (inr (Ordinal (lj : j < h.+1), ord0)).
exists (froot sigma x); first by rewrite inE; exact: roots_root.
apply: val_inj; rewrite /= -e; apply/eqP; rewrite -hub_fconnect; exact: connect_root.
Qed.
End Sizes.

Lemma far_edges_exist f e : inhabited (far_edges_of f e).
Proof.
have Nh : 2 * f.+1 <= 3 * f + 2 by move: f; clear; numbers.
have := far_matchings_exist (camouflaged_layout f e) Nh (even_degree f e).
by case/card_gt0P=> a _; exact: (inhabits a).
Qed.

(* as many pairs of far darts *)
Definition far_pairs_in f e := 6 * f.+1 ^ 2 + f.+1 + 1 + f.+1 * e.

Lemma camouflaged_pairs f e : (3 * f + 2 - 2 * f.+1) * ((12 * f.+1 + 5 + 2 * e).+1 - 4) +
  ((12 * f.+1 + 5 + 2 * e).+1 - 2) = (far_pairs_in f e).*2.
Proof.
rewrite (_ : 3 * f + 2 - 2 * f.+1 = f); last by move: f; clear; numbers.
rewrite (_ : _.+1 - 4 = 12 * f + 14 + 2 * e); last by move: f e; clear; numbers.
rewrite (_ : _.+1 - 2 = 12 * f + 16 + 2 * e); last by move: f e; clear; numbers.
by rewrite /far_pairs_in -mul2n expnS expn1; move: f e; clear; numbers.
Qed.

Lemma far_edges_counted f e : #|{: far_edges_of f e}| = pairings (far_pairs_in f e).*2.
Proof.
have Nh : 2 * f.+1 <= 3 * f + 2 by move: f; clear; numbers.
by rewrite far_matchings_counted (far_counted (camouflaged_layout f e) Nh) camouflaged_pairs.
Qed.

Theorem camouflaged_sizes f e (g : near_loops f e) (a : far_edges_of f e) : let W := camouflaged g a in
  [/\ edges W = 18 * f.+1 ^ 2 + 9 * f.+1 + 1 + 3 * f.+1 * e, vertices W = 3 * f.+1 + 1 &
  exists (y : W) w, 2 * f.+1 < hub y /\ home_word w y].
Proof.
split; last exact: home_word_exists.
  apply: double_inj; rewrite corridor_edges -mul2n expnS expn1; move: f e {g a}; clear; numbers.
by rewrite corridor_vertices; move: f {g a}; clear; numbers.
Qed.

Lemma camouflaged_edges f e (g : near_loops f e) (a : far_edges_of f e) :
  edges (camouflaged g a) + 2 = 3 * far_pairs_in f e + 6 * f.+1.
Proof.
by have [-> _ _] := camouflaged_sizes g a; rewrite /far_pairs_in !expnS expn0; move: f e {g a}; clear; numbers.
Qed.

(* with one near hub of degree 6, and one far hub, at least 4 motions *)
Example few_logs : [seq logs_after 4 T 0 | T <- [:: 3; 4]] = [:: 1; 9].
Proof. by rewrite /= /logs_after !big_ord_recl !big_ord0. Qed.

(* ---------------------------------------------------------------------------------------------
   Corridors, as worlds.                                                               Section VI

   v0 has degree 2; the hubs 1, ..., h+1 have degree r+1.  Two edges, the rails, join each to the one before.
   The first N hubs are near: their other darts are loops.  Those of the far hubs are matched in any way.

     hub, hub_place       at which hub a dart is, 0 for v0, and its place there.
     layout out           out i b: the place of the dart by which rail b leaves hub i+1; rails come in at the
                          places 0 and 1, and r+1 is not too small.
     rail, rail_end       a rail, one of its ends;  on_rail: it is one;  rail_over: the other end.
     near_free, far_free  the other darts, of near and of far hubs.
     free_by_hub          how many they are.
     near_gluing g        g makes loops of the darts of near hubs.
     far_matching         a way to match those of far hubs.
     corridor_world       the world with g and with such a matching.
     camouflaged g a      that with 2F near hubs and F = f+1 far ones, all of degree 12F+6+2e, where the rails
                          leave hub l by the darts -4l and -4l-2.
     corridor_world_is    it is a corridor in the sense of Corridors.v.
     near_loops_exist, home_word_exists   such worlds, and home words in them.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps MassFormula PathWorlds.
From Bounds Require Import Gluings Corridors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Worlds.
Variables (N h r : nat).
Local Notation hub_index := 'I_h.+1.
Local Notation dart := (bool + hub_index * 'I_r.+1)%type.
Variable out : hub_index -> bool -> 'I_r.+1.
Implicit Types (x y : dart) (b : bool).

Definition hub x := if x is inr (i, _) then i.+1 else 0.
Definition hub_place x := match x with | inl b => nat_of_bool b | inr (_, p) => nat_of_ord p end.

(* ---- The edges of the corridor: two into each hub, from v0 or from the hub before ---- *)
Definition rail := (hub_index * bool)%type.
Definition rail_end (q : rail * bool) : dart :=
  let: (i, b, up) := q in
  if up then inr (i, inord b) else if i == ord0 then inl b else inr (inord i.-1, out (inord i.-1) b).
Definition on_rail x := [exists q, rail_end q == x].
Definition rail_over x := if [pick q | rail_end q == x] is Some q then rail_end (q.1, ~~ q.2) else x.

(* what is matched at the near hubs, and at the far ones *)
Definition near_free := [set x | ~~ on_rail x & hub x <= N].
Definition far_free := [set x | ~~ on_rail x & N < hub x].

Record layout : Prop := Layout {
  ring_large : 1 < r;
  out_large : forall i b, 1 < out i b;
  out_apart : forall i, out i false != out i true }.
Hypothesis L : layout.

Lemma rail_end_inj : injective rail_end.
Proof.
have small (b : bool) : b < r.+1 by case: b => //; rewrite ltnS ltnW // (ring_large L).
have bools (b b' : bool) : inord b = inord b' :> 'I_r.+1 -> b = b'.
  by move/(congr1 val); rewrite /= !inordK //; case: b b' => [] [].
have outs i b b' : out i b = out i b' -> b = b'.
  by have := out_apart L i; case: b b' => [] [] // /eqP n e; rewrite e in n.
have pred (i i' : hub_index) : i != ord0 -> i' != ord0 -> inord i.-1 = inord i'.-1 :> hub_index -> i = i'.
  move=> n n' /(congr1 val); rewrite /= !inordK; try by apply: leq_ltn_trans (leq_pred _) (ltn_ord _).
  move=> e; apply: val_inj; rewrite /= -[LHS]prednK ?lt0n // -[RHS]prednK ?lt0n // ?e //.
have apart i (b b' : bool) : out i b != inord b'.
  by apply/eqP=> /(congr1 val) /=; have := out_large L i b; rewrite inordK //; case: b' => + e; rewrite e.
move=> [[i b] u] [[i' b'] u']; rewrite /rail_end; case: u u' => [] [].
- by case=> -> /bools->.
- by case: ifP => // _ [_ /esym/eqP]; rewrite (negbTE (apart _ _ _)).
- by case: ifP => // _ [_ /eqP]; rewrite (negbTE (apart _ _ _)).
case: ifP => [/eqP->|n]; case: ifP => [/eqP->|n'] //; first by case=> ->.
by case=> /(pred _ _ (negbT n) (negbT n')) e; rewrite e => /outs->.
Qed.

Lemma on_rail_end q : on_rail (rail_end q).
Proof. by apply/existsP; exists q. Qed.

Lemma other_rail_end q : rail_over (rail_end q) = rail_end (q.1, ~~ q.2).
Proof. by rewrite /rail_over; case: pickP => [q' /eqP/rail_end_inj->|/(_ q)] //; rewrite eqxx. Qed.

Lemma on_railP x : reflect (exists q, x = rail_end q) (on_rail x).
Proof. by apply: (iffP existsP) => -[q e]; exists q; [rewrite (eqP e) | rewrite e]. Qed.

Lemma down_end j b : j < h -> rail_end (inord j.+1, b, false) = inr (inord j, out (inord j) b).
Proof.
move=> lj; have e : (inord j.+1 : hub_index) = j.+1 :> nat by rewrite inordK // ltnS.
have n : inord j.+1 != ord0 :> hub_index by rewrite -val_eqE /= e.
by rewrite /rail_end (negbTE n) e.
Qed.

(* ---- How many darts are free ---- *)
Definition free_places (i : hub_index) := [set p | ~~ on_rail (inr (i, p))].

Lemma free_placesE (i : hub_index) : free_places i =
  ~: ([set inord false; inord true] :|: (if i < h then [set out i false; out i true] else set0)).
Proof.
apply/setP=> p; rewrite !inE; congr (~~ _); apply/on_railP/idP=> [[[[j b] []] /=]|].
- by case=> -> ->; apply/orP; left; case: b; rewrite /= eqxx ?orbT.
- case: ifP => [//|/negbT j0 [-> ->]]; have j1 : 0 < j by rewrite lt0n.
  have e : (inord j.-1 : hub_index) = j.-1 :> nat.
    by rewrite inordK // (leq_ltn_trans (leq_pred _) (ltn_ord j)).
  by rewrite e -ltnS prednK // ltn_ord !inE; case: b; rewrite eqxx ?orbT.
case/orP=> [/orP[]/eqP->|]; [by exists (i, false, true) | by exists (i, true, true) |].
case: ifP => [li|]; last by rewrite inE.
have up b : inr (i, out i b) = rail_end (inord i.+1, b, false).
  have e : (inord i.+1 : hub_index) = i.+1 :> nat by rewrite inordK // ltnS.
  have n : inord i.+1 != ord0 :> hub_index by rewrite -val_eqE /= e.
  rewrite /rail_end (negbTE n) e /=; have -> : inord i = i by apply: val_inj; rewrite /= inordK.
  by [].
by rewrite !inE => /orP[]/eqP->; rewrite up; eexists.
Qed.

Lemma free_counted (i : hub_index) : #|free_places i| = r.+1 - (if i < h then 4 else 2).
Proof.
rewrite free_placesE cardsCs setCK card_ord; congr (_ - _).
have r1 (b : bool) : b < r.+1 by case: b => //; rewrite ltnS ltnW // (ring_large L).
have two : inord false != inord true :> 'I_r.+1 by apply/eqP=> /(congr1 val); rewrite /= !inordK ?(r1 true).
have ins : #|[set inord false; inord true] : {set 'I_r.+1}| = 2 by rewrite cards2 two.
case: ifP => _; last by rewrite setU0.
rewrite cardsU ins cards2 (out_apart L) disjoint_setI0 ?cards0 //.
rewrite disjoint_subset; apply/subsetP=> p; rewrite !inE => e; apply/negP.
have: p < 2 by case/orP: e => /eqP->; rewrite inordK.
by move=> p2; case/orP=> /eqP e'; have := out_large L i; [move/(_ false) | move/(_ true)];
  rewrite -e' ltnNge -ltnS p2.
Qed.

(* the free darts of the hubs that satisfy A, hub by hub *)
Lemma free_by_hub (A : pred nat) : ~~ A 0 -> #|[set x | ~~ on_rail x & A (hub x)]| =
  \sum_(i : hub_index | A i.+1) (r.+1 - (if i < h then 4 else 2)).
Proof.
move=> A0; pose U := [set x | ~~ on_rail x & A (hub x)].
pose at_hub i : {set dart} := [set x in U | hub x == i.+1].
have each (i : hub_index) : A i.+1 -> #|at_hub i| = r.+1 - (if i < h then 4 else 2).
  move=> Ai; rewrite -free_counted.
  rewrite -(card_imset (mem (free_places i)) (_ : injective (fun p => inr (i, p) : dart))).
    apply: eq_card => x; rewrite !inE; apply/andP/imsetP=> [[/andP[nx _] /eqP]|[p pf ->]].
      by case: x nx => [b|[j p]] //= nx [/val_inj e]; exists p; rewrite ?inE -?e.
    by move: pf; rewrite inE => ->; rewrite /= Ai eqxx.
  by move=> p q [].
rewrite -sum1_card (eq_bigr (fun i : hub_index => #|at_hub i|)) => [|i Ai]; last by rewrite each.
pose index x : hub_index := inord (hub x).-1.
have hubE x : x \in U -> hub x = (index x).+1.
  by rewrite inE => /andP[_]; case: x => [b|[i p]] /=; [rewrite (negbTE A0) | rewrite /index /= inord_val].
rewrite (partition_big index (fun i : hub_index => A i.+1)) /= => [|x xU]; last first.
  by rewrite -hubE //; move: xU; rewrite inE => /andP[].
apply: eq_bigr => i Ai; rewrite -sum1_card; apply: eq_bigl => x; rewrite [RHS]inE.
case xU: (x \in U) => //=; rewrite (hubE x xU) eqSS -val_eqE; by [].
Qed.

(* ---- The worlds ---- *)
Definition corridor_sigma x : dart := match x with | inl b => inl (~~ b) | inr (i, p) => inr (i, after p) end.

Lemma corridor_turn j i p : iter j corridor_sigma (inr (i, p)) = inr (i, iter j (@after r) p).
Proof. by elim: j => // j IH; rewrite !iterS IH. Qed.

Lemma corridor_sigma_inj : injective corridor_sigma.
Proof. by move=> [b|[i p]] [b'|[i' p']] //= [] => [/negb_inj->|-> /after_inj->]. Qed.

Lemma hub_fconnect x y : fconnect corridor_sigma x y = (hub x == hub y).
Proof.
apply/idP/eqP=> [/iter_findex <-|].
  by elim: (findex _ _ _) => // j IH; rewrite iterS IH; case: (iter _ _ _) => [b|[i p]].
case: x y => [b|[i p]] [b'|[i' p']] //= e.
  by case: b b' => [] []; rewrite ?connect0 //; exact: fconnect1.
have <- : i = i' by apply: val_inj; case: e.
by rewrite -(after_reaches p p') -corridor_turn; exact: fconnect_iter.
Qed.

Definition near_gluing (g : {ffun dart -> dart}) :=
  pairs_up near_free g && [forall x in near_free, hub (g x) == hub x].

Lemma pairings_gt0 n : ~~ odd n -> 0 < pairings n.
Proof.
have [k] := ubnP n; elim: k n => // k IH [|[|n]] //=; rewrite negbK => lk on.
by rewrite muln_gt0 /= IH // -ltnS ltnW.
Qed.

Lemma paired_in U (c : {ffun dart -> dart}) x : pairs_up U c -> (c x \in U) = (x \in U).
Proof.
by case/pairs_upP=> K M; apply: negb_inj; rewrite -!M K eq_sym.
Qed.

Lemma near_gluing_exists : N <= h -> ~~ odd r.+1 -> exists g, near_gluing g.
Proof.
move=> Nh ev; pose U (i : hub_index) : {set dart} := [set x | ~~ on_rail x & hub x == i.+1].
have choice (i : hub_index) : exists b : {ffun dart -> dart}, i < N -> pairs_up (U i) b.
  case: (boolP (i < N)) => [li|_]; last by exists (finfun id).
  have : 0 < #|[set b | pairs_up (U i) b]|.
    rewrite pairings_counted pairings_gt0 // (@free_by_hub (pred1 i.+1)) // (big_pred1 i) => [|j /=].
      by rewrite (leq_trans li Nh); move: ev; case: (r) => [|[|[|q]]] //=; rewrite !subSS subn0 !negbK.
    by rewrite eqSS.
  by rewrite card_gt0 => /set0Pn[b]; rewrite inE; exists b.
have [B H] := fin_all_exists choice.
pose index x : hub_index := inord (hub x).-1.
have nearE x : x \in near_free -> [/\ x \in U (index x), index x < N & forall y, y \in U (index x) ->
    [/\ y \in near_free, index y = index x & hub y = hub x]].
  have hubE i p : index (inr (i, p)) = i by rewrite /index /= inord_val.
  case: x => [b|[i p]]; rewrite inE; first by rewrite -[inl b]/(rail_end (ord0, b, false)) on_rail_end.
  rewrite hubE => /andP[nr lN]; split=> // [|y]; first by rewrite inE nr /=.
  rewrite inE => /andP[ny /eqP e]; rewrite !inE ny e /index e /= inord_val; split=> //.
exists [ffun x => if x \in near_free then B (index x) x else x]; apply/andP; split.
  apply/pairs_upP; split=> x; rewrite !ffunE.
    case xn: (x \in near_free); last by rewrite xn.
    have [xU lx back] := nearE x xn; have P := H _ lx.
    have [yn -> _] := back _ (etrans (paired_in x P) xU); rewrite yn.
    by case/pairs_upP: P => ->.
  case xn: (x \in near_free); last by rewrite eqxx.
  by have [xU lx _] := nearE x xn; case/pairs_upP: (H _ lx) => _ ->; rewrite xU.
apply/forall_inP=> x xn; rewrite ffunE xn; have [xU lx back] := nearE x xn.
by have [_ _ ->] := back _ (etrans (paired_in x (H _ lx)) xU).
Qed.

Variable g : {ffun dart -> dart}.
Hypothesis near : near_gluing g.

Definition far_matching := {b : {ffun dart -> dart} | pairs_up far_free b}.

Section OneWorld.
Variable a : far_matching.

Definition corridor_alpha x := if on_rail x then rail_over x else if N < hub x then val a x else g x.

Lemma near_pairs : involutive g /\ forall x, (g x == x) = (x \notin near_free).
Proof. by case/andP: near => /pairs_upP. Qed.

Lemma far_pairs : involutive (val a) /\ forall x, (val a x == x) = (x \notin far_free).
Proof. exact/pairs_upP/valP. Qed.

Lemma glued_in (U : {set dart}) (c : {ffun dart -> dart}) x :
  involutive c -> (forall x, (c x == x) = (x \notin U)) ->
  x \in U -> c x \in U.
Proof. by move=> K M xU; apply/negPn; rewrite -M K eq_sym M xU. Qed.

Lemma alpha_rail q : corridor_alpha (rail_end q) = rail_end (q.1, ~~ q.2).
Proof. by rewrite /corridor_alpha on_rail_end other_rail_end. Qed.

Lemma alpha_far x : x \in far_free -> corridor_alpha x = val a x /\ val a x \in far_free.
Proof.
have [K M] := far_pairs; move=> xf; split; last exact: glued_in K M xf.
by move: xf; rewrite inE /corridor_alpha => /andP[/negbTE-> ->].
Qed.

Lemma alpha_near x : x \in near_free -> [/\ corridor_alpha x = g x, g x \in near_free & hub (g x) = hub x].
Proof.
have [K M] := near_pairs; move=> xn; split; last by case/andP: near => _ /forall_inP/(_ x xn)/eqP.
  by move: xn; rewrite inE leqNgt /corridor_alpha => /andP[/negbTE-> /negbTE->].
exact: glued_in K M xn.
Qed.

Lemma three_kinds x : [\/ exists q, x = rail_end q, x \in near_free | x \in far_free].
Proof.
case: (boolP (on_rail x)) => [/on_railP|o]; first by constructor 1.
by case: (leqP (hub x) N) => l; [constructor 2 | constructor 3]; rewrite inE o.
Qed.

Lemma corridor_alphaK : involutive corridor_alpha.
Proof.
move=> x; case: (three_kinds x) => [[q ->]|xn|xf].
- by rewrite !alpha_rail /= negbK; case: q.
- by have [-> yn _] := alpha_near xn; have [-> _ _] := alpha_near yn; have [K _] := near_pairs; rewrite K.
by have [-> yf] := alpha_far xf; have [-> _] := alpha_far yf; have [K _] := far_pairs; rewrite K.
Qed.

Lemma corridor_alpha_neq x : corridor_alpha x != x.
Proof.
case: (three_kinds x) => [[q ->]|xn|xf].
- by rewrite alpha_rail (inj_eq rail_end_inj); case: q => q u; rewrite xpair_eqE eqxx; case: u.
- by have [-> _ _] := alpha_near xn; have [_ M] := near_pairs; rewrite M xn.
by have [-> _] := alpha_far xf; have [_ M] := far_pairs; rewrite M xf.
Qed.

Lemma corridor_connected x y : connect (adjacent corridor_sigma corridor_alpha) x y.
Proof.
set adj := adjacent _ _.
have same u v : hub u = hub v -> connect adj u v.
  move/eqP; rewrite -hub_fconnect; apply: connect_sub => p q /eqP <-.
  by apply: connect1; rewrite /adj /adjacent eqxx.
have H u : connect adj u (inl false).
  have [n] := ubnP (hub u); elim: n u => // n IH u; rewrite ltnS => lu.
  case E: (hub u) => [|j]; first exact: same.
  have lj : j < h.+1 by move: E; case: (u) => [//|[i p]] /= [<-].
  pose q : rail := (Ordinal lj, false).
  apply: connect_trans (same u (rail_end (q, true)) _) _; first by rewrite E.
  apply: connect_trans (connect1 (_ : adj _ (rail_end (q, false)))) _.
    by rewrite /adj /adjacent alpha_rail eqxx orbT.
  apply: IH; rewrite /rail_end; case: ifP => [_|/negbT n0] /=; first by rewrite (leq_trans _ lu) ?E.
  have j0 : 0 < j by rewrite lt0n.
  rewrite inordK; last exact: leq_ltn_trans (leq_pred _) lj.
  by rewrite prednK // (leq_trans _ lu) // E.
apply: connect_trans (H x) _; rewrite /adj (adjacent_connect_sym corridor_sigma_inj corridor_alphaK).
exact: H.
Qed.

Definition corridor_map :=
  CombinatorialMap corridor_sigma_inj corridor_alphaK corridor_alpha_neq corridor_connected.
Definition corridor_world := @LighthouseWorld corridor_map (inl false) (inl false) (connect0 _ _).
End OneWorld.
End Worlds.

(* ---- The corridors of Corridors.v ---- *)
Section Camouflaged.
Variables f e : nat.
Local Notation F := f.+1.
Local Notation h := (3 * f + 2).
Local Notation r := (12 * f.+1 + 5 + 2 * e).
Local Notation R := (12 * f.+1 + 6 + 2 * e).

Definition way_out_place (i : 'I_h.+1) (b : bool) : 'I_r.+1 := inord (R - 4 * i.+1 - 2 * b).

Lemma ringE : R = r.+1.
Proof. by rewrite addnS addSn. Qed.

Lemma way_out_placeE i b : way_out_place i b + 4 * i.+1 + 2 * b = R /\ 1 < way_out_place i b.
Proof.
have b1 : (b : nat) <= 1 by case: b.
have le : 4 * i.+1 + 2 * b + 2 <= R.
  by have := ltn_ord i; move: b1; move: (nat_of_bool b) (nat_of_ord i); clear; numbers.
rewrite /way_out_place inordK; last first.
  by rewrite -ringE; move: le; move: (nat_of_bool b) (nat_of_ord i) R; clear; numbers.
by move: le; move: (nat_of_bool b) (nat_of_ord i) R; clear; move=> ? ? ? le; split; numbers.
Qed.

Lemma camouflaged_layout : layout way_out_place.
Proof.
split=> [|i b|i].
- by move: f e; clear; numbers.
- by have [] := way_out_placeE i b.
have [E _] := way_out_placeE i false; have [E' _] := way_out_placeE i true.
by apply/eqP=> s; rewrite s -E' in E; move/addnI: E.
Qed.

Variable g : {ffun bool + 'I_h.+1 * 'I_r.+1 -> bool + 'I_h.+1 * 'I_r.+1}.
Hypothesis near : near_gluing (2 * F) way_out_place g.
Variable a : far_matching (2 * F) way_out_place.
Local Notation W := (corridor_world camouflaged_layout near a).
Local Notation rail_end := (rail_end way_out_place).

Lemma up_in (i : 'I_h.+1) b : in_dart (W := W) (@hub _ _) (@hub_place _ _) (rail_end (i, b, true)).
Proof. by rewrite /in_dart /= inordK; case: b. Qed.

Lemma down_out (i : 'I_h.+1) b : 0 < hub (rail_end (i, b, false)) ->
  out_dart F R (W := W) (@hub _ _) (@hub_place _ _) (rail_end (i, b, false)).
Proof.
rewrite /rail_end; case: ifP => //= /negbT i0 _; have li := ltn_ord i.
have j0 : 0 < i by rewrite lt0n.
have i1 : (inord i.-1 : 'I_h.+1) = i.-1 :> nat by rewrite inordK // (leq_ltn_trans (leq_pred _) li).
have [E _] := way_out_placeE (inord i.-1) b; rewrite /out_dart /= i1 prednK // in E *; apply/andP; split.
  by apply: leq_trans li _; move: f; clear; numbers.
by case: b E => E; rewrite -E ?muln1 ?muln0 ?addn0 eqxx ?orbT.
Qed.

Lemma in_up (x : W) : in_dart (W := W) (@hub _ _) (@hub_place _ _) x -> exists i b, x = rail_end (i, b, true).
Proof.
case: x => [b|[i p]] //= /andP[_ /= p2]; exists i, (p == 1 :> nat); congr (inr (_, _)); apply: val_inj.
by rewrite /= inordK; case: (nat_of_ord p) p2 => [|[|]].
Qed.

Lemma out_down (x : W) : out_dart F R (W := W) (@hub _ _) (@hub_place _ _) x ->
  exists i b, x = rail_end (i, b, false) /\ hub x = i.
Proof.
case: x => [b|[i p]] //= /andP[/= lF o].
have li : i.+1 < h.+1 by apply: leq_trans lF _; move: f; clear; numbers.
have [b E'] : exists b : bool, p + 4 * i.+1 + 2 * b = R.
  by case/orP: o => /eqP o; [exists false | exists true]; rewrite ?muln1 ?muln0 ?addn0.
exists (Ordinal li), b; split=> //; rewrite /rail_end /=.
have -> : inord i = i by apply: val_inj; rewrite /= inordK.
have [E _] := way_out_placeE i b; congr (inr (_, _)).
apply: ord_inj; move: E' E; move: (nat_of_ord p) (nat_of_ord (way_out_place i b)) (4 * i.+1) (2 * b).
by clear; numbers.
Qed.

Theorem corridor_world_is : @corridor F R W (@hub _ _) (@hub_place _ _).
Proof.
have alphaE (x : W) : alpha x = corridor_alpha (N := 2 * F) (out := way_out_place) g a x by [].
have railE q : @alpha W (rail_end q) = rail_end (q.1, ~~ q.2).
  by rewrite alphaE (alpha_rail camouflaged_layout).
split.
- exact: leq_addr.
- exact: hub_fconnect.
- by [].
- by move=> [b|[i p]] //=; apply: leq_trans (ltn_ord i) _; move: f; clear; numbers.
- by move=> [b|[i p]] //= _; rewrite ringE.
- by move=> [b|[i p]] //= _; have := after_turn 1 p; rewrite addn1 /= => ->; rewrite ringE.
- move=> [b|[i p]] [b'|[i' p']] //=; first by case: b b' => [] [].
  by move=> [] /val_inj-> /val_inj->.
- by move=> [b _|[i p] //]; have := railE (ord0, b, false); rewrite /= => ->.
- move=> x /in_up[i [b ->]]; rewrite railE; split=> [|/down_out//].
  rewrite /=; case: ifP => [/eqP->|/negbT i0] //=.
  have j0 : 0 < i by rewrite lt0n.
  by rewrite inordK ?prednK //; exact: ltnW (ltn_ord i).
- by move=> x /out_down[i [b [-> E]]]; rewrite railE E.
- move=> x hx ni no; case: (three_kinds (2 * F) way_out_place x) => [[q E]|xn|xf].
  + case: q E => [[i b] []] E; first by rewrite E up_in in ni.
    by rewrite E down_out // -E in no; case/andP: hx.
  + by rewrite alphaE; have [-> _ ->] := alpha_near near a xn.
  by case/andP: hx xf => _; rewrite inE leqNgt => /negbTE->; rewrite andbF.
move=> x hx ni no; case: (three_kinds (2 * F) way_out_place x) => [[q E]|xn|xf].
- case: q E => [[i b] []] E; first by rewrite E up_in in ni.
  by rewrite E down_out // -E ?(leq_trans _ hx) in no.
- by move: xn; rewrite inE leqNgt hx andbF.
by rewrite alphaE; have [-> + ] := alpha_far g a xf; rewrite inE => /andP[].
Qed.
End Camouflaged.

(* the world with F = f+1 far hubs of degree 12F+6+2e, the loops g at the near ones and the matching a at the
   far ones *)
Definition near_loops f e := {g : {ffun _ -> _} | near_gluing (2 * f.+1) (@way_out_place f e) g}.
Definition far_edges_of f e := far_matching (2 * f.+1) (@way_out_place f e).
Definition camouflaged f e (g : near_loops f e) (a : far_edges_of f e) :=
  corridor_world (camouflaged_layout f e) (valP g) a.

Lemma even_degree f e : ~~ odd (12 * f.+1 + 5 + 2 * e).+1.
Proof. by rewrite mul2n -addSn -addnS oddD odd_double addbF oddD oddM. Qed.

Lemma near_loops_exist f e : inhabited (near_loops f e).
Proof.
have [||g G] := @near_gluing_exists (2 * f.+1) _ _ _ (camouflaged_layout f e).
- by move: f; clear; numbers.
- exact: even_degree.
exact: (inhabits (exist _ g G)).
Qed.

(* ---- A home word: down the corridor from the first far hub ---- *)
Section HomeWord.
Variables (f e : nat) (g : near_loops f e) (a : far_edges_of f e).
Local Notation W := (camouflaged g a).
Local Notation rail_end := (rail_end (@way_out_place f e)).
Definition way_down j := [seq 4 * l | l <- rev (iota 1 j)].

Lemma down_the_way j : j < (3 * f + 2).+1 -> forall z : W, z = rail_end (inord j, false, false) ->
  [seq hub x | x <- passed (way_down j) z] = rev (iota 0 j.+1) /\ hub (walk (way_down j) z) = 0.
Proof.
elim: j => [|j IH] lj z ->.
  have E : inord 0 == ord0 :> 'I_(3 * f + 2).+1 by rewrite -val_eqE /= inordK.
  by rewrite /way_down /passed /walk /rail_end E.
have way : way_down j.+1 = 4 * j.+1 :: way_down j.
  by rewrite /way_down -{1}(addn1 j) iotaD rev_cat add1n.
rewrite (down_end _ _ (lj : j < 3 * f + 2)); set z0 : W := inr _.
have hz : hub z0 = j.+1 by rewrite /z0 /hub inordK // ltnW.
have step : @motion W (4 * j.+1) z0 = rail_end (inord j, false, false).
  rewrite /motion /z0 [iter _ _ _]corridor_turn.
  rewrite (_ : inr _ = rail_end (inord j, false, true)); last first.
    congr (inr (_, _)); apply: ord_inj; rewrite after_turn inordK //.
    have [E _] := way_out_placeE e (inord j : 'I_(3 * f + 2).+1) false.
    by move: E; rewrite inordK ?(ltnW lj) // muln0 addn0 => ->; rewrite ringE modnn.
  exact: (alpha_rail (camouflaged_layout f e) (val g) a (inord j, false, true)).
have [p h0] := IH (ltnW lj) _ step; rewrite way; split; last by [].
rewrite passed_cons map_cons p hz.
by rewrite -[in RHS](addn1 j.+1) iotaD rev_cat add0n.
Qed.

Theorem home_word_exists : exists (y : W) w, 2 * f.+1 < hub y /\ home_word w y.
Proof.
have lN : 2 * f.+1 < (3 * f + 2).+1 by move: f; clear; numbers.
pose y : W := rail_end (inord (2 * f.+1), false, true); exists y, (0 :: way_down (2 * f.+1)).
have hy : hub y = (2 * f.+1).+1 by rewrite /y /rail_end /hub inordK.
have step : @motion W 0 y = rail_end (inord (2 * f.+1), false, false).
  exact: (alpha_rail (camouflaged_layout f e) (val g) a (inord (2 * f.+1), false, true)).
have [p h] := down_the_way lN step; rewrite hy; split=> //.
have C := corridor_world_is (valP g) a; apply/andP; split.
  by rewrite (hub_vertex C) [walk _ _]/(walk (way_down (2 * f.+1)) (motion 0 y)) h.
have U : uniq [seq hub x | x <- passed (0 :: way_down (2 * f.+1)) y].
  rewrite passed_cons map_cons p hy.
  by rewrite cons_uniq rev_uniq iota_uniq mem_rev mem_iota ltnn andbF.
move: U; rewrite uniq_pairwise pairwise_map; apply: sub_pairwise => x x'.
by rewrite (hub_vertex C).
Qed.
End HomeWord.

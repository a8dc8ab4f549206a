(* ---------------------------------------------------------------------------------------------
   How many motions a corridor takes: least numbers, some of them computed, and a closed form.  Section VI

   CorridorLogs.v leaves a sum: as many logs as there are ways to match the far darts.

     least_in_corridor N w   the least T after which there are w logs, with N near hubs.
     corridor_needs_least    so many motions in one of the corridors, w the number of matchings.
     row, logs_in_binary     the same sum, in binary numbers: by these the least numbers are computed.
     least_in_camouflage     one motion less would leave too few logs.
     root_of_factorial       y^y <= 3^y y!.
     logs_bounded            with less than 2(N+1)(Y+1) motions at most 3 (Y+1) (12 (N+1))^Y logs.
     squared_pairings        the square of (2M-1)(2M-3)... is at least (2M-1)^M.
     corridor_closed_form    2(N+1)(Y+1) motions in one of the corridors, if 9 (24 (N+1))^2Y < (2M-1)^M.
     camouflaged_needs, camouflaged_order    in the corridors of CorridorWorlds.v with F far hubs and M pairs of far
                             darts: the least T with so many logs; and (2F+1)(M log (2M-1) - 4) / (1 + log (24(2F+1))),
                             logarithms to the base 2, rounded down.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import BinNat Nnat Lia.
From Allworlds Require Import Model RootedMaps Explorers MassFormula.
From Bounds Require Import Corridors CorridorWorlds CorridorLogs.
From Allworlds Require Import Algorithm Refinement Policies.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma logs_sum back T : logs_after back T 0 = \sum_(y < (T %/ back).+1) 'C(T, y) * 2 ^ y.
Proof. by rewrite /logs_after addn0. Qed.

(* ---- The least number of motions ---- *)
Section Least.
Variable N : nat.
Local Notation logs T := (logs_after (2 * N.+1) T 0).

Definition least_in_corridor w := find (fun T => w <= logs T) (iota 0 (2 * N.+1 + w).+1).

Lemma logs_grow T T' : T <= T' -> logs T <= logs T'.
Proof. by move=> le; apply: logs_after_le; rewrite ?addn0. Qed.

Lemma logs_enough w : w <= logs (2 * N.+1 + w).
Proof.
have [Y q] : exists Y, (2 * N.+1 + w) %/ (2 * N.+1) = Y.+1.
  by exists (w %/ (2 * N.+1)); rewrite -{1}(mul1n (2 * N.+1)) divnMDl // add1n.
rewrite logs_sum q big_ord_recl big_ord_recl /= bin0 muln1 bin1 expn1 add1n muln2 -addnn.
by apply: leq_trans (leqnSn _); apply: leq_trans (leq_addr _ _); rewrite -addnA addnCA leq_addr.
Qed.

Theorem least_in_corridorP w T : (least_in_corridor w <= T) = (w <= logs T).
Proof.
have some : has (fun T => w <= logs T) (iota 0 (2 * N.+1 + w).+1).
  by apply/hasP; exists (2 * N.+1 + w); rewrite ?mem_iota ?logs_enough //= add0n ltnSn.
have lt : least_in_corridor w < (2 * N.+1 + w).+1 by rewrite -[X in _ < X](size_iota 0) -has_find.
apply/idP/idP=> [le|en].
  by have := nth_find 0 some; rewrite nth_iota // add0n => en; exact: leq_trans en (logs_grow le).
rewrite leqNgt; apply/negP=> l; have := before_find 0 l; rewrite nth_iota ?add0n ?en //.
exact: ltn_trans l lt.
Qed.

Lemma least_is w T : w <= logs T.+1 -> ~~ (w <= logs T) -> least_in_corridor w = T.+1.
Proof. by rewrite -!least_in_corridorP => le; rewrite -ltnNge => lt; apply/eqP; rewrite eqn_leq le. Qed.
End Least.

Theorem corridor_needs_least N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) g
    (near : near_gluing N out g) : N <= h -> ~~ odd r.+1 ->
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_matching N out,
     finds_map meaning X (rooted (@start (corridor_world L near a)))
       (@percept_of (corridor_world L near a))) ->
  exists a : far_matching N out, forall fuel t e z,
  episode X (rooted (@start (corridor_world L near a))) (@percept_of (corridor_world L near a)) fuel
    = (t, Some e, z) ->
  least_in_corridor N (pairings ((h - N) * (r.+1 - 4) + (r.+1 - 2))) <= size t.
Proof.
move=> Nh ev E meaning X H; have [a A] := @corridor_costs _ _ _ _ L _ near Nh ev _ _ _ H.
by exists a => fuel t e z /A; rewrite least_in_corridorP logs_sum.
Qed.

(* ---- The sum in binary ---- *)
Local Notation to_nat := N.to_nat.

Fixpoint sums (a b : seq N) : seq N := if (a, b) is (x :: a', y :: b') then N.add x y :: sums a' b' else [::].

(* 'C(T, 0), ..., 'C(T, Y) *)
Fixpoint row T Y : seq N :=
  if T is T'.+1 then let r := row T' Y in sums r (N0 :: r) else 1%num :: nseq Y N0.

Definition doubled (r : seq N) : N := foldr (fun x s => N.add x (N.double s)) N0 r.
Definition logs_in_binary back T : N := doubled (row T (T %/ back)).
Fixpoint pairings_in_binary k : N :=
  if k is k'.+1 then N.mul (N.succ_double (N.of_nat k')) (pairings_in_binary k') else 1%num.

Lemma size_row T Y : size (row T Y) = Y.+1.
Proof.
have sz : forall a b : seq N, size b = (size a).+1 -> size (sums a b) = size a.
  by elim=> [|x a IH] [|y b] //= [e]; rewrite IH.
by elim: T => [|T IH] /=; [rewrite size_nseq | rewrite sz].
Qed.

Lemma nth_row T Y y : y <= Y -> to_nat (nth N0 (row T Y) y) = 'C(T, y).
Proof.
have at_ : forall (a b : seq N) i, size b = (size a).+1 -> i < size a ->
    to_nat (nth N0 (sums a b) i) = to_nat (nth N0 a i) + to_nat (nth N0 b i).
  elim=> [|x a IH] [|y' b] //= [|i] [e] //= li; first by rewrite N2Nat.inj_add.
  exact: IH.
elim: T y => [|T IH] y le; first by case: y le => [|y] //= le; rewrite nth_nseq le bin0n.
have sz : size (N0 :: row T Y) = (size (row T Y)).+1 by [].
rewrite [row _ _]/= at_ // ?size_row //; case: y le => [|y] le; first by rewrite IH // !bin0 addn0.
by rewrite [nth _ (_ :: _) _]/= !IH ?binS // ltnW.
Qed.

Lemma to_nat_doubled (r : seq N) : to_nat (doubled r) = \sum_(y < size r) to_nat (nth N0 r y) * 2 ^ y.
Proof.
elim: r => [|x r IH] /=; first by rewrite big_ord0.
rewrite big_ord_recl /= muln1 N2Nat.inj_add N2Nat.inj_double IH plusE; congr (_ + _).
rewrite -[Nat.mul _ _]/(2 * _) big_distrr /=; apply: eq_bigr => y _.
by rewrite expnS mulnCA.
Qed.

Lemma logs_binary back T : to_nat (logs_in_binary back T) = logs_after back T 0.
Proof.
rewrite to_nat_doubled size_row logs_sum; apply: eq_bigr => y _.
by rewrite nth_row // -ltnS.
Qed.

Lemma pairings_binary k : to_nat (pairings_in_binary k) = pairings k.*2.
Proof.
elim: k => [|k IH] //; rewrite doubleS [LHS]/= N2Nat.inj_mul IH N2Nat.inj_succ_double Nat2N.id.
by rewrite [RHS]/= -[Nat.mul 2 k]/(2 * k) mul2n.
Qed.

Lemma binary_le a b : N.leb a b = (to_nat a <= to_nat b).
Proof.
apply/idP/idP=> [/N.leb_le|/leP] le; first by apply/leP; lia.
by apply/N.leb_le; lia.
Qed.

Lemma least_by_binary N k T : N.leb (pairings_in_binary k) (logs_in_binary (2 * N.+1) T.+1) ->
  ~~ N.leb (pairings_in_binary k) (logs_in_binary (2 * N.+1) T) ->
  least_in_corridor N (pairings k.*2) = T.+1.
Proof. by rewrite !binary_le pairings_binary !logs_binary; exact: least_is. Qed.

(* N = 2F, F = 1, 2, 3: the corridors with 28, 91 and 190 edges, 8, 27 and 58 pairs of far darts in them *)
Lemma least_in_camouflage :
  [/\ least_in_corridor 2 (pairings 8.*2) = 30, least_in_corridor 4 (pairings 27.*2) = 216 &
      least_in_corridor 6 (pairings 58.*2) = 728].
Proof.
split; [apply: (@least_by_binary 2 8 29) | apply: (@least_by_binary 4 27 215) |
        apply: (@least_by_binary 6 58 727)]; vm_cast_no_check (erefl true).
Qed.

(* ---- Powers and factorials ---- *)
Lemma power_of_successor y : y.+1 ^ y <= 3 * y ^ y.
Proof.
case: y => // n; set y := n.+1; pose A i := 'C(y, i) * y ^ (y - i).
have falls i : 0 < i < y -> 2 * A i.+1 <= A i.
  case/andP=> i0 iy; have y0 : 0 < y by [].
  have e : i.+1 * A i.+1 * y = (y - i) * A i.
    by rewrite /A mulnA -mulnA -expnSr subnSK // mul_bin_left -mulnA.
  rewrite -(leq_pmul2r y0); apply: leq_trans (_ : i.+1 * A i.+1 * y <= _).
    by rewrite !leq_mul2r ltnS i0 !orbT.
  by rewrite e mulnC leq_mul2l leq_subr orbT.
have below j : 0 < j <= y -> \sum_(i < j.+1) A i + A j <= 3 * y ^ y.
  elim: j => // -[_ _|j IH /andP[_ lj]].
    rewrite !big_ord_recl big_ord0 addn0 /A /= bin0 subn0 mul1n bin1 subn1 -expnS.
    by rewrite -addnA !mulSn mul0n addn0.
  rewrite big_ord_recr /= -addnA addnn -mul2n; apply: leq_trans (IH (ltnW lj)).
  by rewrite leq_add2l falls.
have := below y (introT andP (conj (ltn0Sn n) (leqnn y))); apply: leq_trans.
apply: leq_trans (leq_addr _ _); rewrite -[X in X ^ _](addn1 y) expnDn; apply: eq_leq.
by apply: eq_bigr => i _; rewrite exp1n muln1.
Qed.

Lemma root_of_factorial y : y ^ y <= 3 ^ y * y`!.
Proof.
elim: y => // y IH; rewrite factS [y.+1 ^ _]expnS [3 ^ _]expnS.
apply: leq_trans (_ : y.+1 * (3 * y ^ y) <= _); first by rewrite leq_mul2l power_of_successor orbT.
by rewrite mulnCA -!mulnA leq_mul2l mulnCA leq_mul2l IH !orbT.
Qed.

Lemma falling_power T y : 'C(T, y) * y`! <= T ^ y.
Proof.
rewrite bin_ffact; elim: y => // y IH; rewrite ffactnSr expnSr; apply: leq_mul IH _.
exact: leq_subr.
Qed.

Lemma logs_bounded N T Y : T < 2 * N.+1 * Y.+1 ->
  logs_after (2 * N.+1) T 0 <= 3 * Y.+1 * (12 * N.+1) ^ Y.
Proof.
set back := 2 * N.+1 => lT; have b0 : 0 < back by [].
rewrite logs_sum; set q := T %/ back.
have qY : q <= Y by rewrite -ltnS ltn_divLR // mulnC.
have q2 : q + q <= T.
  by rewrite addnn -muln2; apply: leq_trans (leq_trunc_div T back); rewrite leq_mul2l /back leq_pmulr ?orbT.
have grows y : y < q -> 'C(T, y) <= 'C(T, y.+1).
  move=> ly; rewrite -(leq_pmul2l (ltn0Sn y)) mul_bin_left leq_mul2r; apply/orP; right.
  by rewrite leq_subRL ?(leq_trans (ltnW ly)) ?(leq_trans _ q2) ?leq_addr // leq_add // ltnW.
have most y : y <= q -> 'C(T, y) * 2 ^ y <= 'C(T, q) * 2 ^ q.
  move=> le; suff le' : 'C(T, y) <= 'C(T, q) by apply: leq_mul => //; rewrite leq_exp2l.
  elim: (q) le grows => [|p IH] le up; first by move: le; rewrite leqn0 => /eqP->.
  move: le; rewrite leq_eqVlt => /predU1P[->//|]; rewrite ltnS => le.
  by apply: leq_trans (up p (ltnSn p)); apply: IH le _ => i /ltnW; exact: up.
have last : 'C(T, q) * 2 ^ q <= 3 * (12 * N.+1) ^ q.
  have qq : 0 < q ^ q by rewrite expn_gt0; case: (q).
  rewrite -(leq_pmul2l qq); apply: leq_trans (_ : (6 * T) ^ q <= _).
    apply: leq_trans (leq_mul (root_of_factorial q) (leqnn _)) _.
    rewrite [3 ^ q * _]mulnC mulnACA [q`! * _]mulnC -expnMn mulnC.
    by rewrite [X in _ <= X]expnMn leq_mul2l falling_power orbT.
  apply: leq_trans (_ : (12 * N.+1 * q.+1) ^ q <= _).
    have -> : 12 * N.+1 * q.+1 = 6 * (q.+1 * back) by rewrite mulnCA mulnC /back -[12]/(6 * 2) !mulnA.
    have : 6 * T <= 6 * (q.+1 * back) by rewrite leq_mul2l ltnW // ltn_ceil.
    by case: (q) => // e; rewrite leq_exp2r.
  by rewrite expnMn [X in _ <= X]mulnC [3 * _]mulnC -mulnA leq_mul2l power_of_successor orbT.
apply: leq_trans (_ : q.+1 * ('C(T, q) * 2 ^ q) <= _).
  apply: leq_trans (_ : \sum_(y < q.+1) 'C(T, q) * 2 ^ q <= _).
    by apply: leq_sum => y _; apply: most; rewrite -ltnS.
  by rewrite sum_nat_const card_ord.
apply: leq_trans (leq_mul (qY : q.+1 <= Y.+1) last) _; rewrite mulnA mulnC [X in _ <= X]mulnC [_ * 3]mulnC.
by rewrite leq_mul2r leq_pexp2l ?orbT.
Qed.

(* ---- A closed form ---- *)
Lemma pairings_product M : pairings M.*2 = \prod_(i < M) i.*2.+1.
Proof.
elim: M => [|M IH]; first by rewrite big_ord0.
by rewrite doubleS big_ord_recr /= -IH mulnC.
Qed.

Lemma squared_pairings M : (M.*2.-1) ^ M <= pairings M.*2 ^ 2.
Proof.
rewrite expnS expn1 pairings_product [X in X * _](reindex_inj rev_ord_inj) -big_split /=.
rewrite -[X in _ ^ X](card_ord M) -prod_nat_const; apply: leq_prod => i _.
have -> : M.*2.-1 = ((M - i.+1) + i).*2.+1.
  by case: M i => [[]//|M] i; rewrite subSS subnK // -ltnS.
rewrite -!muln2; move: (M - i.+1) (nat_of_ord i) => a b; apply/leP; rewrite -!(plusE, multE); nia.
Qed.

Theorem corridor_closed_form N h r (out : 'I_h.+1 -> bool -> 'I_r.+1) (L : layout out) g
    (near : near_gluing N out g) M Y : N <= h -> ~~ odd r.+1 ->
  (h - N) * (r.+1 - 4) + (r.+1 - 2) = M.*2 -> 9 * (24 * N.+1) ^ (2 * Y) < M.*2.-1 ^ M ->
  forall E (meaning : E -> rooted_map) (X : explorer percept E),
  (forall a : far_matching N out,
     finds_map meaning X (rooted (@start (corridor_world L near a)))
       (@percept_of (corridor_world L near a))) ->
  exists a : far_matching N out, forall fuel t e z,
  episode X (rooted (@start (corridor_world L near a))) (@percept_of (corridor_world L near a)) fuel
    = (t, Some e, z) -> 2 * N.+1 * Y.+1 <= size t.
Proof.
move=> Nh ev c large E meaning X H; have [a A] := @corridor_costs _ _ _ _ L _ near Nh ev _ _ _ H.
exists a => fuel t e z R; rewrite leqNgt; apply/negP=> lt; move: large; rewrite ltnNge => /negP[].
apply: leq_trans (squared_pairings M) _; rewrite -c.
have le : pairings ((h - N) * (r.+1 - 4) + (r.+1 - 2)) <= 3 * (24 * N.+1) ^ Y.
  have := A _ _ _ _ R; rewrite -logs_sum => /leq_trans; apply.
  apply: leq_trans (logs_bounded lt) _; rewrite -mulnA leq_mul2l /= (_ : 24 * N.+1 = 2 * (12 * N.+1)) ?mulnA //.
  by rewrite -[2 * 12 * _]mulnA [X in _ <= X]expnMn leq_mul2r; apply/orP; right; exact: ltn_expl.
by rewrite [2 * Y]mulnC expnM -[9]/(3 ^ 2) -expnMn leq_exp2r.
Qed.

(* ---- In the corridors of CorridorWorlds.v ---- *)
Section Camouflaged.
Variables (f e : nat) (g : near_loops f e).
Local Notation F := f.+1.
Local Notation M := (far_pairs_in f e).
Local Notation W := (fun a : far_edges_of f e => camouflaged g a).
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Hypothesis finds : forall a, finds_map meaning X (rooted (@start (W a))) (@percept_of (W a)).
Local Notation takes b := (exists a, forall fuel t e z,
  episode X (rooted (@start (W a))) (@percept_of (W a)) fuel = (t, Some e, z) -> b <= size t).

Lemma nearer : 2 * F <= 3 * f + 2.
Proof. by move: f; clear; numbers. Qed.

Theorem camouflaged_needs : takes (least_in_corridor (2 * F) (pairings M.*2)).
Proof.
rewrite -camouflaged_pairs.
exact: (@corridor_needs_least _ _ _ _ (camouflaged_layout f e) _ (valP g) nearer (even_degree f e) _ meaning).
Qed.

Lemma camouflaged_closed_form Y : 9 * (24 * (2 * F).+1) ^ (2 * Y) < M.*2.-1 ^ M -> takes (2 * (2 * F).+1 * Y.+1).
Proof.
move=> large; exact: (@corridor_closed_form _ _ _ _ (camouflaged_layout f e) _ (valP g) M Y nearer
  (even_degree f e) (camouflaged_pairs f e) large _ meaning).
Qed.

Theorem camouflaged_order : exists a, forall fuel t e z,
  episode X (rooted (@start (W a))) (@percept_of (W a)) fuel = (t, Some e, z) ->
  (2 * F).+1 * (M * trunc_log 2 M.*2.-1 - 4) <= size t * (trunc_log 2 (24 * (2 * F).+1)).+1.
Proof.
set l := trunc_log 2 M.*2.-1; set k := (trunc_log 2 _).+1; pose Y := (M * l - 5) %/ (2 * k).
have M8 : 8 <= M by rewrite /far_pairs_in expnS expn1; move: f e; clear; numbers.
have M15 : 15 <= M.*2.-1 by rewrite -ltnS prednK ?double_gt0 ?(leq_trans _ M8) // (leq_double 8).
have l3 : 3 <= l by apply: trunc_log_max => //; exact: leq_trans M15.
have Ml : 5 <= M * l by apply: leq_trans (leq_mul M8 l3).
have small : 24 * (2 * F).+1 < 2 ^ k by apply: trunc_log_ltn.
have large : 2 ^ l <= M.*2.-1 by apply: trunc_logP => //; exact: leq_trans M15.
have Yk : 2 * Y * k <= M * l - 5 by rewrite [2 * Y]mulnC -mulnA leq_trunc_div.
have Yl : M * l - 4 <= 2 * k * Y.+1.
  have : M * l - 5 < Y.+1 * (2 * k) by apply: ltn_ceil.
  by rewrite -subSn // subSS [Y.+1 * _]mulnC.
have [|a A] := @camouflaged_closed_form Y.
  apply: leq_trans (_ : (2 ^ l) ^ M <= _); last by rewrite leq_exp2r // (leq_trans _ M8).
  apply: leq_trans (_ : 2 ^ 4 * (2 ^ k) ^ (2 * Y) <= _); last first.
    rewrite -!expnM -expnD leq_exp2l // [l * M]mulnC [k * _]mulnC.
    by move: Yk Ml; move: (2 * Y * k) (M * l); clear; numbers.
  apply: leq_trans (_ : (9 + 1) * (2 ^ k) ^ (2 * Y) <= _); last by rewrite leq_mul2r orbT.
  rewrite mulnDl mul1n; apply: leq_ltn_trans (_ : 9 * (2 ^ k) ^ (2 * Y) < _).
    by rewrite leq_mul2l /=; case: (2 * Y) => // y; rewrite leq_exp2r // ltnW.
  by rewrite -[X in X < _]addn0 ltn_add2l !expn_gt0.
exists a => fuel t r z /A le; apply: leq_trans (_ : (2 * F).+1 * (2 * k * Y.+1) <= _).
  by rewrite leq_mul2l Yl orbT.
by rewrite [2 * k]mulnC -mulnA mulnCA [X in _ <= X]mulnC leq_mul2l mulnA [_ * 2]mulnC le orbT.
Qed.
End Camouflaged.

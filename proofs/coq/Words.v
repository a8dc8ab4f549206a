(* ---------------------------------------------------------------------------------------------
   Words, and which of them are powers.

     proper_power u       u is v written k times, for some word v and some k >= 2.
     primitive u          u is no proper power.
     blank u              every letter of u is 0.

     turned_power         a cyclic word that some turn by less than its length leaves as it is is a proper
                          power.
     primitive_turn       so turns of a primitive word differ.
     power_periodic       and a proper power repeats itself.
     one_then_zeros_primitive, counting_primitive   1 0 ... 0 and 1 2 ... d are primitive;
     halves_primitive, distances_primitive   so are 1 ... 1 2 ... 2 and 1 2 3 ... 3 2;
     remainders_primitive   1 2 ... q 1 2 ... is unless q divides the length, and is less.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition proper_power (u : seq nat) := exists v k, 1 < k /\ u = flatten (nseq k v).
Definition primitive u := ~ proper_power u.
Definition blank (u : seq nat) := all (fun letter => letter == 0) u.

Lemma size_power k (v : seq nat) : size (flatten (nseq k v)) = k * size v.
Proof. by elim: k => //= k IH; rewrite size_cat IH. Qed.

Lemma nth_power k (v : seq nat) b : b < k * size v ->
  nth 0 (flatten (nseq k v)) b = nth 0 v (b %% size v).
Proof.
elim: k b => // k IH b; rewrite mulSn /= nth_cat => lt; case: ltnP => le; first by rewrite modn_small.
by rewrite IH ?ltn_subLR // -{2}(subnK le) modnDr.
Qed.

(* what repeats itself after p and after d steps, repeats itself after their gcd *)
Theorem turned_power (f : nat -> nat) d q : 0 < q < d ->
  (forall b, f (b %% d) = f ((b + q) %% d)) -> proper_power (mkseq f d).
Proof.
case/andP=> q0 qd H; have d0 := ltn_trans q0 qd; set p := gcdn q d.
pose g b := f (b %% d); have gd b j : g (b + j * d) = g b by rewrite /g addnC modnMDl.
have gq b j : g (b + j * q) = g b.
  by elim: j => [|j IH]; rewrite ?addn0 // mulSn addnCA addnC {1}/g -H.
have gp b : g (b + p) = g b.
  have [i j E _] := egcdnP d q0.
  by rewrite -(gd (b + p) j) -addnA [p + _]addnC -E gq.
have gj b j : g (b + j * p) = g b.
  by elim: j => [|j IH]; rewrite ?addn0 // mulSn addnCA addnC gp.
have p0 : 0 < p by rewrite gcdn_gt0 q0.
have pq : p <= q by rewrite dvdn_leq ?dvdn_gcdl.
have D : d = d %/ p * p by rewrite divnK ?dvdn_gcdr.
exists (mkseq f p), (d %/ p); split.
  by rewrite ltn_divRL ?dvdn_gcdr // mul1n; exact: leq_ltn_trans pq qd.
apply: (@eq_from_nth _ 0) => [|b]; rewrite !size_mkseq; first by rewrite size_power size_mkseq.
move=> bd; rewrite nth_power size_mkseq -?D // !nth_mkseq ?ltn_pmod //.
have bp : b %% p < d by apply: leq_ltn_trans (leq_mod _ _) bd.
by have := gj (b %% p) (b %/ p); rewrite addnC -divn_eq /g (modn_small bd) (modn_small bp).
Qed.

(* turned by different amounts, a primitive word is different *)
Lemma primitive_turn (f : nat -> nat) d b b' : primitive (mkseq f d) -> b < d -> b' < d ->
  (forall c, f ((c + b) %% d) = f ((c + b') %% d)) -> b = b'.
Proof.
move=> Pr; wlog lt : b b' / b < b' => [hyp bd bd' H|].
  case: (ltngtP b b') => // lt; first exact: hyp.
  by apply/esym/hyp => // c; rewrite H.
move=> bd bd' H; case: Pr; apply: (@turned_power _ _ (b' - b)).
  by rewrite subn_gt0 lt (leq_ltn_trans (leq_subr _ _) bd').
move=> c; have := H (c + (d - b)).
have -> : c + (d - b) + b' = c + (b' - b) + d.
  by rewrite -!addnA addnBAC ?(ltnW bd) // addnBAC ?(ltnW lt) // [b' + d]addnC.
by rewrite -addnA subnK ?(ltnW bd) // !modnDr.
Qed.

Theorem power_periodic (f : nat -> nat) d k v : mkseq f d = flatten (nseq k v) ->
  d = k * size v /\ forall b, b < d -> f b = f (b %% size v).
Proof.
move=> E; have D : d = k * size v by rewrite -size_power -E size_mkseq.
split=> // b bd; have bd' : b %% size v < d by apply: leq_ltn_trans (leq_mod _ _) bd.
by rewrite -(nth_mkseq 0 f bd) -(nth_mkseq 0 f bd') E !nth_power -?D // modn_mod.
Qed.

(* a letter that stands in one place only *)
Lemma once_primitive (f : nat -> nat) d : 0 < d -> (forall b, b < d -> f b = f 0 -> b = 0) ->
  primitive (mkseq f d).
Proof.
move=> d0 H [v [k [k1 E]]]; have [D P] := power_periodic E.
have v0 : 0 < size v by move: d0; rewrite D muln_gt0 => /andP[].
have vd : size v < d by rewrite D -{1}[size v]mul1n ltn_pmul2r.
by have := H _ vd; rewrite P // modnn => /(_ erefl) Z; rewrite Z in v0.
Qed.

Lemma one_then_zeros_primitive d : 0 < d -> primitive (mkseq (fun b => b == 0 : nat) d).
Proof. by move=> d0; apply: once_primitive => // -[]. Qed.

Lemma counting_primitive d : 0 < d -> primitive (mkseq succn d).
Proof. by move=> d0; apply: once_primitive => // b _ []. Qed.

(* the remainders modulo q, each counted from 1 *)
Theorem remainders_primitive q d : 0 < q -> 0 < d ->
  primitive (mkseq (fun b => (b %% q).+1) d) <-> ~~ ((q %| d) && (q < d)).
Proof.
move=> q0 d0; split=> [Pr|/negP N [v [k [k1 /power_periodic[D P]]]]].
  apply/negP=> /andP[/dvdnP[k D] lt]; apply: Pr; exists (mkseq (fun b => (b %% q).+1) q), k; split.
    by move: lt; rewrite D -{1}[q]mul1n ltn_pmul2r.
  apply: (@eq_from_nth _ 0) => [|b]; rewrite ?size_power !size_mkseq // => bd.
  by rewrite nth_power size_mkseq -?D // !nth_mkseq ?ltn_pmod // modn_mod.
have v0 : 0 < size v by move: d0; rewrite D muln_gt0 => /andP[].
have vd : size v < d by rewrite D -{1}[size v]mul1n ltn_pmul2r.
have [Z] := P _ vd; move: Z; rewrite modnn mod0n => /eqP qv; apply: N.
by rewrite (leq_ltn_trans (dvdn_leq v0 qv) vd) D dvdn_mull.
Qed.

(* 1 in the first half, 2 in the second *)
Lemma halves_primitive d : 0 < d -> primitive (mkseq (fun b => if b.*2 < d then 1 else 2) d).
Proof.
move=> d0 [v [k [k1 /power_periodic[D P]]]].
have v0 : 0 < size v by move: d0; rewrite D muln_gt0 => /andP[].
have two : (size v).*2 <= d by rewrite D -mul2n leq_mul2r k1 orbT.
have := P d.-1; rewrite prednK // leqnn => /(_ isT).
have -> : d.-1 %% size v = (size v).-1.
  case: k k1 D {P two} => // k _ D; rewrite {1}D mulSn addnC -subn1 -addnBA // modnMDl subn1 modn_small //.
  by rewrite prednK.
have d1 : 1 < d by apply: leq_trans two; rewrite -addnn; case: (size v) v0 => // n _; rewrite addnS.
rewrite ifN; last by rewrite -leqNgt -addnn -ltnS -addSn prednK // -[X in X < _]addn0 ltn_add2l -ltnS prednK.
rewrite ifT // (leq_trans _ two) // ltn_double prednK //.
Qed.

(* how far it is, on the shorter side *)
Lemma distances_primitive d : 0 < d -> primitive (mkseq (fun b => (minn b (d - b)).+1) d).
Proof.
move=> d0; apply: once_primitive => // b lt [E]; have := subn_gt0 b d; rewrite lt => gt.
by move: E; rewrite min0n /minn; case: ifP => // _ E; rewrite E in gt.
Qed.

(* ---------------------------------------------------------------------------------------------
   Words, and which of them are powers.

     proper_power u       u is v written k times, for some word v and some k >= 2.
     primitive u          u is no proper power.
     blank u              every letter of u is 0.

     turned_power         a cyclic word that some turn by less than its length leaves as it is is a proper
                          power.
     power_periodic       and a proper power repeats itself.
     one_then_zeros_primitive, counting_primitive   1 0 ... 0 and 1 2 ... d are primitive.
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

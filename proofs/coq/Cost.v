(* ---------------------------------------------------------------------------------------------
   Cost: what a pass and a whole run cost, in edge traversals, retracing included.      Section VI

     pass_bound m s p     a pass begun with s vertices in S after p earlier passes: s + 2 (s-1)
                          (2m - 2p).
     run_bound n m q      pass_bound summed over q passes, S growing by one vertex a pass up to n.

     pass_cost            no pass costs more than pass_bound.
     run_cost             q passes cost at most run_bound n m q, whatever the order of loops and
                          non-loops: no exchange argument is needed.
     run_bound_paper      for q = m that is (1) + (2), term by term.
     paper_bound_polynomial   (1) + (2) = 2m^2 n - 2mn^2 + (2/3)n^3 - 2m^2 + 5mn - (5/2)n^2 - 2m +
                          (11/6)n; stated without division and subtraction.  The printed (3)
                          leaves out 5mn.
     paper_bound_le       (1) + (2) <= 2 m^2 n: the cost is O(m^2 n), with the constant 2.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps Percepts PartialMaps HypothesisTests Pass.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition pass_bound m s p := s + 2 * (s - 1) * (2 * m - 2 * p).
Definition run_bound n m q := \sum_(0 <= p < q) pass_bound m (minn p.+1 n) p.

(* ---- One pass ---- *)
Section PassCost.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation m := (edges W).
Local Notation n := (vertices W).

Lemma unequal_lists (T : eqType) (s t : seq T) :
  size s = size t -> s <> t -> has (fun q => q.1 != q.2) (zip s t).
Proof.
elim: s t => [|x s IH] [|y t] //= [sz] ne; case: eqP => //= xy.
by apply: IH => // st; apply: ne; rewrite xy st.
Qed.

(* a rejected test walks at most the whole path *)
Lemma steps_walked_le S e (x : W) t : rejected S e x t -> steps_walked S x t <= size (degrees S) - 1.
Proof.
case: t => h w [/= _ _ [f [Rw _ sw]] ne]; rewrite subn1 -ltnS.
have sz : size (percepts_along w x) = size (expected_percepts (first_bearing W) S w h).
  by rewrite size_percepts (size_expected W Rw).
have := unequal_lists sz ne; rewrite has_find size_zip -sz minnn size_percepts => lt.
by rewrite prednK ?(leq_ltn_trans _ sw) //; apply: leq_trans lt _.
Qed.

Lemma tests_cost_le S e (x : W) ts : (forall t, t \in ts -> rejected S e x t) ->
  tests_cost S x ts <= 2 * (size (degrees S) - 1) * size ts.
Proof.
move=> Rj; rewrite /tests_cost.
apply: (@leq_trans (\sum_(t <- ts) 2 * (size (degrees S) - 1))).
  by rewrite !big_seq; apply: leq_sum => t m'; rewrite leq_mul2l /= (steps_walked_le (Rj t m')).
by rewrite big_const_seq count_predT iter_addn_0.
Qed.

Lemma hypotheses_le S r p hs : embedded v0 S r -> size (links S) = p.*2 -> uniq hs ->
  (forall h, h \in hs -> is_open S h) -> size hs <= 2 * m - 2 * p.
Proof.
move=> I sz U O; have := open_and_explored I U O.
by rewrite sz -edges_double !mul2n => le; rewrite -(leq_add2r p.*2) subnK // (leq_trans _ le) ?leq_addl.
Qed.

Theorem pass_cost e (c : configuration W) C c' p : sound c -> size (links (mapped c)) = p.*2 ->
  pass e c C c' ->
  C <= pass_bound m (size (degrees (mapped c))) p.
Proof.
move=> Ok sz P; case: P Ok sz => S d q w0 k ts => [h w f|] x [_ sw0 _] Rj U.
  move=> oh he [_ _ sw] V [r [/= I _ _ _]] sz.
  have H : size (h :: unzip1 ts) <= 2 * m - 2 * p.
    apply: (hypotheses_le I sz U) => h'; rewrite inE => /orP[/eqP->//|/mapP[t m' ->]].
    by case: (Rj t m').
  rewrite /= size_map in H; rewrite /pass_bound -addnA leq_add //; first by rewrite addn1.
  apply: (@leq_trans (2 * (size (degrees S) - 1) * (size ts).+1)); last by rewrite leq_mul2l H orbT.
  rewrite mulnS addnC leq_add ?(tests_cost_le Rj) //.
  rewrite mul2n -addnn (leq_trans _ (leq_addr _ _)) // subn1 -ltnS prednK //.
  exact: leq_ltn_trans sw.
move=> _ [r [/= I _ _ _]] sz.
have H : size (unzip1 ts) <= 2 * m - 2 * p.
  by apply: (hypotheses_le I sz U) => h' /mapP[t m' ->]; case: (Rj t m').
rewrite size_map in H; rewrite /pass_bound leq_add //; first by rewrite addn1.
by apply: leq_trans (tests_cost_le Rj) _; rewrite leq_mul2l H orbT.
Qed.

(* ---- The whole run ---- *)
Lemma pass_bound_mono s t p : s <= t -> pass_bound m s p <= pass_bound m t p.
Proof. by move=> st; rewrite /pass_bound leq_add // leq_mul2r leq_mul2l /= leq_sub2r ?orbT. Qed.

Theorem run_cost q C c : reached (W := W) q C c -> C <= run_bound n m q.
Proof.
elim=> [|p C0 e c1 C1 c2 R Cb P]; first by rewrite /run_bound big_geq.
rewrite /run_bound big_nat_recr //= leq_add //.
apply: leq_trans (pass_cost (reached_sound R) (reached_links R) P) _.
apply: pass_bound_mono; rewrite leq_min (reached_size R) /=.
by have [r [I _ _ _]] := reached_sound R; exact: (size_vertices I).
Qed.
End PassCost.

(* ---- (1) + (2) ---- *)
Lemma run_bound_paper n m : 0 < n -> n - 1 <= m -> run_bound n m m = paper_bound n m.
Proof.
case: n => // n _; rewrite subn1 /= => le; rewrite /run_bound /paper_bound /sum_1 /sum_2 subn1 /=.
rewrite (big_cat_nat _ (n := n)) //=; congr (_ + _).
  rewrite big_add1 /= !big_nat; apply: eq_bigr => p /andP[_ lp].
  by rewrite /pass_bound (minn_idPl _) ?subn1 //= ltnS ltnW.
rewrite -{1}[n]add0n big_addn big_add1 /= !big_nat; apply: eq_bigr => i _.
rewrite /pass_bound (minn_idPr _) ?ltnS ?leq_addl // !subn1 /=.
by rewrite mulnDr subnDA subnAC.
Qed.

Lemma square_sum_1 q m : q <= m ->
  6 * (\sum_(0 <= s < q) (s.+1 + 2 * s * (2 * m - 2 * s))) + 4 * (q - 1) * q * (2 * q - 1)
  = 3 * q * q.+1 + 12 * m * q * (q - 1).
Proof.
elim: q => [|q IH] le; first by rewrite big_geq // !(muln0, mul0n).
have {}IH := IH (ltnW le); rewrite big_nat_recr //=.
move: (\sum_(_ <= _ < _) _) IH => X; rewrite -(subnKC le); move: (m - q.+1) => j.
have -> : 2 * (q.+1 + j) - 2 * q = 2 * j + 2 by rewrite -mulnBr addSnnS addKn mulnS addnC.
case: q {le} => [|q]; rewrite ?subn1 /=; first by rewrite -!(plusE, multE, minusE); lia.
rewrite -!(plusE, multE); lia.
Qed.

Lemma square_sum_2 n k :
  \sum_(0 <= i < k) (n + 2 * (n - 1) * (2 * k - 2 * i)) = n * k + 2 * (n - 1) * k * k.+1.
Proof.
elim: k => [|k IH]; first by rewrite big_geq // !(muln0, mul0n).
rewrite big_nat_recl //= (eq_bigr (fun i => n + 2 * (n - 1) * (2 * k - 2 * i))).
  by rewrite IH muln0 subn0; move: (n - 1) => p; rewrite -!(plusE, multE); lia.
by move=> i _; rewrite !mulnS subnDl.
Qed.

Theorem paper_bound_polynomial n m : 0 < n -> n - 1 <= m ->
  6 * paper_bound n m + 12 * m * n ^ 2 + 12 * m ^ 2 + 15 * n ^ 2 + 12 * m
  = 12 * m ^ 2 * n + 4 * n ^ 3 + 30 * m * n + 11 * n.
Proof.
case: n => // n _; rewrite subn1 /= => le.
have E1 : sum_1 n.+1 m = \sum_(0 <= s < n) (s.+1 + 2 * s * (2 * m - 2 * s)).
  by rewrite /sum_1 big_add1 /=; apply: eq_bigr => s _; rewrite subn1.
have E2 : sum_2 n.+1 m = n.+1 * (m - n) + 2 * n * (m - n) * (m - n).+1.
  have := square_sum_2 n.+1 (m - n); rewrite !subn1 /= => <-; rewrite /sum_2 big_add1 /= subn1 /=.
  by apply: eq_bigr => i _; rewrite subn1 (mulnBr 2 m).
have := square_sum_1 le; rewrite -E1 /paper_bound E2; move: (sum_1 _ _) => X.
move: le => /subnKC; move: (m - n) => k <- {m E1 E2}; rewrite !expnS !expn0 !muln1.
case: n => [|n]; rewrite ?subn1 /=; first by rewrite -!(plusE, multE); lia.
rewrite -!(plusE, multE); lia.
Qed.

Theorem paper_bound_le n m : 0 < n -> n - 1 <= m -> paper_bound n m <= 2 * m ^ 2 * n.
Proof.
move=> n0 le; have := paper_bound_polynomial n0 le; case: n n0 le => // n _.
rewrite subn1 /= => /subnKC; move: (m - n) (paper_bound _ _) => k X <- {m}.
rewrite !expnS !expn0 !muln1 => E; apply/leP; move: E.
have : k <= k * k by case: k => // k; exact: leq_pmulr.
by move/leP; rewrite -!(plusE, multE); lia.
Qed.

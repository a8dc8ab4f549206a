(* ---------------------------------------------------------------------------------------------
   Worlds that look alike when only the position is marked have the same size.         Section III

   Two maps, each seen from the dart that the robot faces first; the robot senses the degree, and whether
   it is at the vertex v0 where it started.  If no motions tell them apart, they have as many edges, as
   many vertices, and as many vertices of each degree.

   Why: pair the darts that the same motions and turns lead to.  Every dart of one map is paired with
   equally many darts of the other; and what the start d is paired with lies at v0, where turning goes
   round in both maps alike, so that the number is the same from both sides.

     position_of v0 d     what is sensed in dart d: the degree, and whether it is a dart of v0.
     look_alike d e       every list of motions gives equal percepts from d and from e.
     paired               the least relation that pairs d and e and is kept by sigma and alpha.

     alike_edges, alike_vertices, alike_degree, alike_degrees   the sizes are equal.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Indistinguishable.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition position_of (G : combinatorial_map) (v0 d : G) := (degree d, at_same_vertex v0 d).

Definition look_alike (G H : combinatorial_map) (d : G) (e : H) := forall w : seq nat,
  percepts_in (M := rooted d) (position_of d) w d = percepts_in (M := rooted e) (position_of e) w e.

(* ---- A bisimulation pairs each dart with equally many ---- *)
Section Paired.
Variables (G H : combinatorial_map) (d : G) (e : H) (R : G -> H -> bool).
Hypotheses (R0 : R d e) (R_sigma : forall x y, R x y -> R (sigma x) (sigma y)).
Hypothesis R_alpha : forall x y, R x y -> R (alpha x) (alpha y).
Hypothesis R_percept : forall x y, R x y -> position_of d x = position_of e y.

Lemma partners_le x x' : #|[pred y | R x y]| <= #|[pred y | R x' y]|.
Proof.
pose A x' := #|[pred y | R x y]| <= #|[pred y | R x' y]|; apply: (@everywhere G A x) => [|z Az|z Az]; first exact: leqnn.
all: apply: leq_trans Az _.
  rewrite -(card_image (@sigma_inj H)); apply/subset_leq_card/subsetP=> y /imageP[u Ru ->].
  exact: R_sigma.
rewrite -(card_image (@alpha_inj H)); apply/subset_leq_card/subsetP=> y /imageP[u Ru ->].
exact: R_alpha.
Qed.

Lemma partners x x' : #|[pred y | R x y]| = #|[pred y | R x' y]|.
Proof. by apply/eqP; rewrite eqn_leq !partners_le. Qed.

(* what d is paired with lies at v0; turned on, d comes to be paired with e *)
Lemma partners_at_start : #|[pred y | R d y]| <= #|[pred x | R x e]|.
Proof.
have at_v0 y : R d y -> fconnect sigma e y.
  by move/R_percept=> -[_]; rewrite /at_same_vertex connect0 => <-.
have R_turn k x y : R x y -> R (iter k sigma x) (iter k sigma y).
  by move=> Rxy; elim: k => //= k; exact: R_sigma.
have deg : degree d = degree e by have [] := R_percept R0.
pose back y := iter (degree e - findex sigma e y) sigma d.
rewrite -(card_in_image (f := back) (A := [pred y | R d y])).
  apply/subset_leq_card/subsetP=> x /imageP[y Rdy ->].
  have c := at_v0 y Rdy; rewrite inE /back.
  have {3}<- : iter (degree e - findex sigma e y) sigma y = e.
    rewrite -[X in iter _ _ X](iter_findex c) -iterD subnK ?iter_degree //.
    exact/ltnW/findex_max.
  exact: R_turn.
move=> y z /at_v0 cy /at_v0 cz E.
have small u : fconnect sigma e u -> findex sigma e u <= degree d.
  by move/findex_max/ltnW; rewrite deg.
have K u : fconnect sigma e u -> iter (findex sigma e u) sigma (back u) = d.
  by move=> c; rewrite /back -iterD -deg subnKC ?iter_degree ?small.
rewrite -(iter_findex cy) -(iter_findex cz); congr iter.
wlog le : y z cy cz E / findex sigma e y <= findex sigma e z.
  by move=> hyp; case/orP: (leq_total (findex sigma e y) (findex sigma e z)) => /hyp; auto=> ->.
apply/eqP; rewrite eqn_leq le leqNgt; apply/negP=> lt.
have := K z cz; rewrite -E -(subnK le) iterD K // => F.
have lt' : findex sigma e z - findex sigma e y < degree d.
  by apply: leq_ltn_trans (leq_subr _ _) _; rewrite deg; exact: findex_max.
have := findex_iter lt'; rewrite F findex0 => /esym/eqP.
by rewrite subn_eq0 leqNgt lt.
Qed.
End Paired.

(* ---- The pairs that the same turns and crossings lead to ---- *)
Section Alike.
Variables (G H : combinatorial_map) (d : G) (e : H).

Definition paired_step (p q : G * H) :=
  (q == (sigma p.1, sigma p.2)) || (q == (alpha p.1, alpha p.2)).
Definition paired x y := connect paired_step (d, e) (x, y).

Lemma paired_start : paired d e. Proof. exact: connect0. Qed.

Lemma paired_sigma x y : paired x y -> paired (sigma x) (sigma y).
Proof. by move/connect_trans; apply; apply: connect1; rewrite /paired_step eqxx. Qed.

Lemma paired_alpha x y : paired x y -> paired (alpha x) (alpha y).
Proof. by move/connect_trans; apply; apply: connect1; rewrite /paired_step eqxx orbT. Qed.

Hypothesis A : look_alike d e.

Lemma paired_alike x y : paired x y ->
  alike (M := rooted d) (N := rooted e) (position_of d) (position_of e) x y.
Proof.
pose B (q : G * H) := alike (M := rooted d) (N := rooted e) (position_of d) (position_of e) q.1 q.2.
have [WG WH] := (rooted_wellformed d, rooted_wellformed e).
case/connectP=> p P E; suff : B (last (d, e) p) by rewrite -E.
have: B (d, e) by split.
elim: p (d, e) P {E} => //= q p IH [u v] /andP[/orP[]/eqP-> P] Buv; apply: IH P _.
  exact: (alike_sigma WG WH Buv).
exact: (alike_alpha WG WH Buv).
Qed.

Lemma paired_percept x y : paired x y -> position_of d x = position_of e y.
Proof. by move/paired_alike/alike_percept. Qed.
End Alike.

Lemma paired_flip (G H : combinatorial_map) (d : G) (e : H) x y : paired d e x y = paired e d y x.
Proof.
suff half (G' H' : combinatorial_map) (d' : G') (e' : H') u v : paired d' e' u v -> paired e' d' v u.
  by apply/idP/idP; exact: half.
case/connectP=> p P E; have -> : (u = (last (d', e') p).1) by rewrite -E.
have -> : (v = (last (d', e') p).2) by rewrite -E.
elim/last_ind: p P {E} => [_|p q IH]; first exact: connect0.
rewrite rcons_path last_rcons => /andP[/IH K /orP[]/eqP->] /=; [exact: paired_sigma|exact: paired_alpha].
Qed.

Section Sizes.
Variables (G H : combinatorial_map) (d : G) (e : H).
Hypothesis A : look_alike d e.
Local Notation R := (paired d e).

Lemma alike_flip : look_alike e d. Proof. by move=> w; rewrite A. Qed.

Definition partner_count := #|[pred y | R d y]|.

Lemma partner_count_gt0 : 0 < partner_count.
Proof. by apply/card_gt0P; exists e; exact: paired_start. Qed.

Lemma partners_of x : #|[pred y | R x y]| = partner_count.
Proof. by apply: partners; [exact: paired_sigma | exact: paired_alpha]. Qed.

Lemma partners_back y : #|[pred x | R x y]| = partner_count.
Proof.
have flip z : #|[pred x | R x z]| = #|[pred x | paired e d z x]|.
  by apply: eq_card => x; rewrite !inE paired_flip.
rewrite flip (@partners _ _ (paired e d) _ _ y e); [|exact: paired_sigma|exact: paired_alpha].
have start (G' H' : combinatorial_map) (d' : G') (e' : H') : look_alike d' e' ->
    #|[pred y | paired d' e' d' y]| <= #|[pred x | paired d' e' x e']|.
  move=> A'; apply: partners_at_start; [exact: paired_start | exact: paired_sigma |].
  exact: paired_percept.
apply/eqP; rewrite eqn_leq -flip start // andbT.
have -> : partner_count = #|[pred y | paired e d y d]|.
  by apply: eq_card => z; rewrite !inE paired_flip.
by rewrite flip; apply: start; exact: alike_flip.
Qed.

(* counting pairs from both sides *)
Theorem alike_sum (g : nat -> nat) : \sum_(x : G) g (degree x) = \sum_(y : H) g (degree y).
Proof.
apply/eqP; rewrite -(eqn_pmul2r partner_count_gt0); apply/eqP; rewrite !big_distrl /=.
transitivity (\sum_(x : G) \sum_(y | R x y) g (degree x)).
  by apply: eq_bigr => x _; rewrite sum_nat_const (partners_of x) mulnC.
rewrite (exchange_big_dep predT) //=; apply: eq_bigr => y _.
transitivity (\sum_(x | R x y) g (degree y)).
  by apply: eq_bigr => x /(paired_percept A)[-> _].
by rewrite sum_nat_const (partners_back y) mulnC.
Qed.

Theorem alike_darts : #|G| = #|H|.
Proof. by have := alike_sum (fun _ => 1); rewrite !sum1_card. Qed.

Theorem alike_edges : edges G = edges H.
Proof. by apply: double_inj; rewrite !edges_double alike_darts. Qed.

Theorem alike_degree : degree d = degree e.
Proof. by have [] := paired_percept A (paired_start d e). Qed.

(* as many darts, and so as many vertices, of each degree *)
Theorem alike_degrees k : #|[pred x : G | degree x == k]| = #|[pred y : H | degree y == k]|.
Proof.
have := alike_sum (fun j => j == k); rewrite -!sum1_card !(big_mkcond (fun x => x \in _)) /= => E.
transitivity (\sum_(x : G) (degree x == k : nat)); first by apply: eq_bigr => x _; rewrite inE; case: eqP.
by rewrite E; apply: eq_bigr => x _; rewrite inE; case: eqP.
Qed.
End Sizes.

(* each vertex weighs as much as any other, if a dart weighs in inverse proportion to the degree *)
Lemma weigh_vertices (G : combinatorial_map) M : (forall x : G, degree x %| M) ->
  \sum_(x : G) M %/ degree x = vertices G * M.
Proof.
move=> dv; have sym := fconnect_sym (@sigma_inj G).
rewrite (partition_big (froot sigma) (froots sigma)) => [|x _]; last exact: roots_root.
rewrite -sum_nat_const /vertices /n_comp_mem.
transitivity (\sum_(r | froots (@sigma G) r) M).
  apply: eq_bigr => r rr; rewrite (eq_bigr (fun _ => M %/ degree r)) => [|x /eqP <-]; last first.
    by rewrite (degree_same (connect_root _ x)).
  rewrite sum_nat_const -[RHS](divnK (dv r)) mulnC; congr (_ * _).
  apply: eq_card => x; rewrite !inE -(root_connect sym) eq_sym (eqP rr).
  by rewrite -/(at_same_vertex r x).
by apply: eq_bigl => r; rewrite !inE andbT.
Qed.

Theorem alike_vertices (G H : combinatorial_map) (d : G) (e : H) : look_alike d e ->
  vertices G = vertices H.
Proof.
move=> A; set M := (#|G|)`!; have dv (K : combinatorial_map) : #|K| = #|G| -> forall x : K, degree x %| M.
  by move=> E x; apply: dvdn_fact; rewrite degree_gt0 -E max_card.
apply/eqP; rewrite -(eqn_pmul2r (fact_gt0 #|G|)) -/M -!weigh_vertices; first exact/eqP/(alike_sum A).
  exact/dv/esym/(alike_darts A).
exact: dv.
Qed.

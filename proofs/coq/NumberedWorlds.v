(* ---------------------------------------------------------------------------------------------
   Worlds that are written down as lists of numbers: what is computed and extracted.

     sensed M pt d            the percept in dart d of M, the marker pointing along dart pt:
                              computed.
     in_numbers               a valid and connected numbered_map as a map of Maps.v.
     world_of_numbers         with a marker, pointing to the k-th dart clockwise from the root.
     sensed_percept           sensed is percept_of.
     algorithm1_in_numbers    the theorem for every world that can be written down, its conclusion
                              decided by same_code.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable Cost.
From Allworlds Require Import Algorithm Refinement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition degree_at M d :=
  (find (fun k => iter k.+1 (nth 0 (sigma_list M)) d == d) (iota 0 (size (sigma_list M)))).+1.
Definition sensed M pt d : percept :=
  let n := degree_at M d in
  let points k := iter k (nth 0 (sigma_list M)) d == pt in
  (n, if has points (iota 0 n) then Some (find points (iota 0 n)) else None).

Lemma find_iota (p : pred nat) n k :
  k < n -> p k -> (forall j, j < k -> ~~ p j) -> find p (iota 0 n) = k.
Proof.
move=> kn pk H; have hp : has p (iota 0 n) by apply/hasP; exists k; rewrite ?mem_iota.
apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt.
  by have := before_find 0 lt; rewrite nth_iota // add0n pk.
have := nth_find 0 hp; rewrite nth_iota ?(ltn_trans lt) // add0n; exact/negP/H.
Qed.

Section Numbered.
Variable M : numbered_map.
Hypothesis V : valid M.
Hypothesis C : connected (denote M).
Let n := size (sigma_list M).
Let wf := validP V.

Definition ord_sigma (i : 'I_n) : 'I_n :=
  Ordinal (wellformed_sigma wf (ltn_ord i) : nth 0 (sigma_list M) i < n).
Definition ord_alpha (i : 'I_n) : 'I_n :=
  Ordinal (wellformed_alpha wf (ltn_ord i) : nth 0 (alpha_list M) i < n).
Definition ord_root : 'I_n := Ordinal (wellformed_root wf : root_number M < n).

Lemma ord_sigma_inj : injective ord_sigma.
Proof. by move=> i j /(congr1 val) E; apply: val_inj; apply: (wellformed_inj wf) => //=;
  exact: ltn_ord. Qed.

Lemma ord_alphaK : involutive ord_alpha.
Proof. by move=> i; apply: val_inj; apply: (wellformed_alphaK wf); exact: ltn_ord. Qed.

Lemma ord_alpha_neq i : ord_alpha i != i.
Proof. by apply/eqP=> /(congr1 val); apply: (wellformed_alpha_neq wf); exact: ltn_ord. Qed.

Lemma ord_connected x y : connect (adjacent ord_sigma ord_alpha) x y.
Proof.
set adj := adjacent _ _; have sym := adjacent_connect_sym ord_sigma_inj ord_alphaK.
suff R z : connect adj ord_root z by apply: connect_trans (R y); rewrite sym; exact: R.
have: forall l : z < n, connect adj ord_root (Ordinal l).
  apply: (C (A := fun i => forall l : i < n, connect adj ord_root (Ordinal l))) =>
    [l|i li Hi l|i li Hi l|].
  - by rewrite (_ : Ordinal l = ord_root) ?connect0 //; exact: val_inj.
  - apply: connect_trans (Hi li) (connect1 _); apply/orP; left; apply/eqP; exact: val_inj.
  - apply: connect_trans (Hi li) (connect1 _); apply/orP; right; apply/eqP; exact: val_inj.
  - exact: ltn_ord.
move/(_ (ltn_ord z)); congr connect; exact: val_inj.
Qed.

Definition in_numbers := CombinatorialMap ord_sigma_inj ord_alphaK ord_alpha_neq ord_connected.
Definition world_of_numbers k : lighthouse_world :=
  @LighthouseWorld in_numbers ord_root (iter k ord_sigma ord_root) (fconnect_iter _ _ _).

Lemma val_turn k (i : in_numbers) : val (iter k sigma i) = iter k (nth 0 (sigma_list M)) (val i).
Proof. by elim: k => //= k ->. Qed.

Lemma numbers_isomorphic (z : in_numbers) : isomorphic (rooted z) (rooted_at (denote M) (val z)).
Proof.
exists val, (insubd ord_root); split=> //= x; first by move=> _; split=> //; rewrite ?valKd.
by move=> lx; split=> //; rewrite insubdK.
Qed.

Section Marked.
Variable k : nat.
Local Notation W := (world_of_numbers k).
Local Notation pt := (iter k (nth 0 (sigma_list M)) (root_number M)).

Lemma sensed_percept (i : W) : sensed M pt (val i) = percept_of i.
Proof.
have P : pt = val (@pointed W) by rewrite val_turn.
have E j (u : W) : (iter j (nth 0 (sigma_list M)) (val i) == val u) = (iter j sigma i == u).
  by rewrite -val_turn.
have o0 := degree_gt0 i; have on : degree i <= n by rewrite -[X in _ <= X](card_ord n) max_card.
have D : degree_at M (val i) = degree i.
  rewrite /degree_at -(prednK o0); congr _.+1; apply: find_iota; first by rewrite prednK.
    by rewrite E prednK // iter_degree.
  move=> j lj; rewrite E; apply/eqP=> F; have lj' : j.+1 < degree i by rewrite -(prednK o0) ltnS.
  by have := findex_iter lj'; rewrite F findex0.
rewrite /sensed D P /percept_of /bearing; congr (_, _).
have -> : has (fun j => iter j (nth 0 (sigma_list M)) (val i) == val (@pointed W)) (iota 0 (degree i))
    = at_same_vertex i pointed.
  apply/hasP/idP=> [[j _]|c]; first by rewrite E => /eqP <-; exact: fconnect_iter.
  by exists (findex sigma i (@pointed W)); rewrite ?mem_iota ?findex_max // E iter_findex.
case: ifP => // c; congr Some; apply: find_iota; first exact: findex_max.
  by rewrite E iter_findex.
move=> j lj; rewrite E; apply/eqP=> F; have := findex_iter (ltn_trans lj (findex_max c)).
by rewrite F => H; rewrite H ltnn in lj.
Qed.

Theorem algorithm1_in_numbers pol budget : paper_bound (vertices W) (edges W) <= budget ->
  exists t e z,
  [/\ episode (algorithm1 pol) (denote M) (sensed M pt) budget = (t, Some e, z),
      size t <= paper_bound (vertices W) (edges W) & same_code e (seen_from M z)].
Proof.
case/(algorithm1_correct pol) => t [e [z [A Cb Ve Ie]]].
have T : (episode (algorithm1 pol) (denote M) (sensed M pt) budget).1
    = (episode (algorithm1 pol) (rooted (@start W)) (@percept_of W) budget).1.
  apply: (@twins_episode _ _ _ (denote M) (rooted (@start W)) (sensed M pt) (@percept_of W)
    (fun (i : nat) (j : W) => i = val j)) => //= x y -> //.
  exact: sensed_percept.
have rz := explore_walk (algorithm1 pol) (M := rooted (@start W)) (@percept_of W) budget
  [:: percept_of (@start W)] start.
have rz' := explore_walk (algorithm1 pol) (M := denote M) (sensed M pt) budget
  [:: sensed M pt (root_number M)] (root_number M).
rewrite -[explore _ _ _ _ _ _]/(episode (algorithm1 pol) (rooted (@start W)) (@percept_of W)
  budget) A /= in rz.
rewrite -[explore _ _ _ _ _ _]/(episode (algorithm1 pol) (denote M) (sensed M pt) budget) T A /= in rz'.
rewrite A /= in T.
have zz : (episode (algorithm1 pol) (denote M) (sensed M pt) budget).2 = val z.
  rewrite rz' rz; have G w (i : nat) (j : W) : i = val j ->
    walk_in (denote M) w i = val (walk_in (rooted (@start W)) w j).
    elim: w i j => //= a w IH i j ij; apply: IH; rewrite /motion_in /= ij; congr (nth _ _ _).
    exact: esym (val_turn a j).
  exact: G.
exists t, e, (val z); split=> //; first by rewrite [LHS]surjective_pairing T zz.
have Vz : valid (seen_from M (val z)).
  by case/and5P: V => s1 _ s3 s4 s5; apply/and5P; split=> //; exact: ltn_ord.
have I := isomorphic_trans Ie (numbers_isomorphic z).
apply: same_code_complete => //; apply: (isomorphic_connected (validP Ve) Ie).
exact: rooted_connected.
Qed.
End Marked.
End Numbered.

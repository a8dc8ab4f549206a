(* ---------------------------------------------------------------------------------------------
   Families of worlds: any world at the end of a path; loops; complete graphs.         Section VI

     longer W, at_end_of_path L W   W with an edge before v0; with L edges before it, v0 at their end.
     bouquet k            one vertex with k+1 loops.
     complete k           the complete graph with k+3 vertices.
     longer_in_universe, at_end_in_universe   what is put at the end of a path stays simple.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts Excursions.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Any world at the end of a path ---- *)
Section OneLonger.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).

(* two more darts: inr false at the new v0, inr true next to the dart that was faced at the old v0 *)
Definition longer_sigma (x : W + bool) : W + bool :=
  match x with
  | inl d => if d == v0 then inr true else inl (sigma d)
  | inr b => if b then inl (sigma v0) else inr false
  end.
Definition longer_alpha (x : W + bool) : W + bool :=
  match x with inl d => inl (alpha d) | inr b => inr (~~ b) end.

Lemma longer_sigma_inj : injective longer_sigma.
Proof.
move=> [x|[]] [y|[]] //=.
- by case: (x =P v0) => [->|_]; case: (y =P v0) => [->|_] // [/sigma_inj ->].
- by case: (x =P v0) => [->|ne] // [/sigma_inj /ne].
- by case: (x =P v0).
- by case: (y =P v0) => [->|ne] // [/sigma_inj /esym /ne].
by case: (y =P v0).
Qed.

Lemma longer_alphaK : involutive longer_alpha.
Proof. by move=> [x|[]] //=; rewrite alphaK. Qed.

Lemma longer_alpha_neq x : longer_alpha x != x.
Proof. by case: x => [x|[]] //=; have := alpha_neq x; apply: contra => /eqP[->]. Qed.

Lemma longer_connected x y : connect (adjacent longer_sigma longer_alpha) x y.
Proof.
set adj := adjacent _ _.
have cs u : connect adj u (longer_sigma u) by apply: connect1; rewrite /adj /adjacent eqxx.
have ca u : connect adj u (longer_alpha u) by apply: connect1; rewrite /adj /adjacent eqxx orbT.
have first : connect adj (inr false) (inl v0).
  apply: connect_trans (ca (inr false)) _;
    rewrite /adj (adjacent_connect_sym longer_sigma_inj longer_alphaK).
  by have := cs (inl v0); rewrite /= eqxx.
have H u : connect adj (inr false) u.
  case: u => [d|[]]; [|exact: ca (inr false)|exact: connect0].
  move: d; apply: (everywhere first) => d R; last exact: connect_trans R (ca (inl d)).
  case: (d =P v0) => [->|/eqP ne]; first exact: connect_trans (ca (inr false)) (cs (inr true)).
  by apply: connect_trans R _; have := cs (inl d); rewrite /= (negbTE ne).
apply: connect_trans (H y); by rewrite /adj (adjacent_connect_sym longer_sigma_inj longer_alphaK).
Qed.

Definition longer_map :=
  CombinatorialMap longer_sigma_inj longer_alphaK longer_alpha_neq longer_connected.
Definition longer := @LighthouseWorld longer_map (inr false) (inr false) (connect0 _ _).

Lemma edges_longer : edges longer = (edges W).+1.
Proof. by apply: double_inj; rewrite edges_double card_sum card_bool doubleS edges_double addn2.
  Qed.

(* the vertices of W remain, and inr true comes to the old v0 *)
Lemma longer_same (d d' : W) : fconnect sigma d d' -> fconnect (@sigma longer) (inl d) (inl d').
Proof.
move/iter_findex <-; elim: (findex _ _ _) => //= k IH; apply: connect_trans IH _.
move: (iter k sigma d) => u; case: (u =P v0) => [->|/eqP ne].
  rewrite (_ : inl (sigma v0) = iter 2 (@sigma longer) (inl v0)) ?fconnect_iter //=.
  by rewrite eqxx.
by rewrite (_ : inl (sigma u) = @sigma longer (inl u)) ?fconnect1 //= (negbTE ne).
Qed.

Lemma longer_joined : fconnect (@sigma longer) (inl v0) (inr true).
Proof. by rewrite (_ : inr true = @sigma longer (inl v0)) ?fconnect1 //= eqxx. Qed.

(* the vertex of W that x lies at; None for the new one *)
Definition old_vertex (x : longer) : option W :=
  match x with
  | inl d => Some (froot sigma d)
  | inr b => if b then Some (froot sigma v0) else None
  end.

Lemma old_vertexE (x y : longer) : at_same_vertex x y = (old_vertex x == old_vertex y).
Proof.
have step (d : W) : froot sigma (sigma d) = froot sigma d.
  apply/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))) (fconnect_sym (@sigma_inj W)).
  exact: fconnect1.
have inv (z : longer) : old_vertex (sigma z) = old_vertex z.
  by case: z => [d|[]] //=; rewrite ?step //; case: eqP => [->|_] //=; rewrite step.
have symW (d d' : W) : Some (froot sigma d) = Some (froot sigma d') -> fconnect sigma d d'.
  by case=> /eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))).
have sym := fconnect_sym (@sigma_inj longer).
apply/idP/eqP=> [/iter_findex <-|]; first by elim: (findex _ _ _) => // k IH; rewrite iterS inv.
case: x y => [d|b] [d'|b'] /=.
- by move/symW/longer_same.
- case: b' => // /symW E; apply: connect_trans longer_joined; exact: longer_same.
- case: b => // /symW E; rewrite /at_same_vertex sym; apply: connect_trans longer_joined.
  by apply: longer_same; rewrite (fconnect_sym (@sigma_inj W)).
by case: b b' => [] [] // _; exact: connect0.
Qed.

Lemma vertices_longer : vertices longer = (vertices W).+1.
Proof.
pose roots_of (G : combinatorial_map) : {set G} := [set r in froots (@sigma G)].
have card_roots (G : combinatorial_map) : vertices G = #|roots_of G|.
  by rewrite cardsE /vertices /n_comp_mem; apply: eq_card => r; rewrite !inE andbT.
have sym := fconnect_sym (@sigma_inj longer).
have same_root (x : longer) : old_vertex (froot sigma x) = old_vertex x.
  by apply/esym/eqP; rewrite -old_vertexE; exact: connect_root.
have inj : {in roots_of longer &, injective old_vertex}.
  move=> x y; rewrite !inE => /eqP rx /eqP ry /eqP; rewrite -old_vertexE.
  by rewrite /at_same_vertex -(root_connect sym) rx ry => /eqP.
rewrite (card_roots longer) -(card_in_imset inj) (card_roots W).
have -> : old_vertex @: roots_of longer = None |: Some @: roots_of W.
  apply/setP=> x; rewrite in_setU1; apply/imsetP/orP=> [[y ry ->]|].
    case: y ry => [d|[]] ry /=; [right | right | by left].
      by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
    by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
  case=> [/eqP->|/imsetP[r rr ->]].
    exists (froot sigma (inr false : longer)); last by rewrite same_root.
    by rewrite inE; exact: (roots_root sym).
  exists (froot sigma (inl r : longer)); first by rewrite inE; exact: (roots_root sym).
  by rewrite same_root /=; move: rr; rewrite inE => /eqP->.
rewrite cardsU1 card_imset; last by move=> u v [].
by have -> : None \notin Some @: roots_of W by apply/imsetP=> -[].
Qed.

Lemma longer_in_universe u : in_universe u W -> in_universe u longer.
Proof.
have sym := fconnect_sym (@sigma_inj W).
have same (d d' : W) : Some (froot sigma d) = Some (froot sigma d') -> at_same_vertex d d'.
  by case=> /eqP; rewrite (root_connect sym).
case: u => // S x y; rewrite !old_vertexE => /eqP c /eqP; move: c.
by case: x y => [d|[]] [d'|[]] //= /same c /same c'; rewrite (S _ _ c c').
Qed.

Lemma longer_path L level up : @path_from_start W L level up ->
  @path_from_start longer L.+1
    (fun x => match x with inl d => (level d).+1 | inr b => b : nat end)
    (fun j => if j is j'.+1 then inl (up j') else inr false).
Proof.
move=> P; have l0 := level_start P; split=> //.
- by case=> [d|[]] /=; [case: eqP => [->|_] /=; rewrite ?(level_sigma P) ?l0
  | rewrite (level_sigma P) l0 |].
- by case=> [d|[]] //=; rewrite ltnS; exact: (level_max P).
- by case=> [d|[]] //=; rewrite ltnS; exact: (level_step P).
case=> [d|[]] /=; [|by right|by left].
rewrite ltnS => /(level_path P) [[E U]|[E U]]; [left | right]; split; rewrite ?E //; congr inl.
  exact: U.
exact: U.
Qed.
End OneLonger.

Fixpoint at_end_of_path L W := if L is L'.+1 then longer (at_end_of_path L' W) else W.

Lemma at_end_path L W : exists level up, @path_from_start (at_end_of_path L W) L level up.
Proof.
elim: L => [|L [level [up P]]]; first by exists (fun=> 0), (fun=> start).
by do 2 eexists; exact: longer_path P.
Qed.

Lemma at_end_edges L W : edges (at_end_of_path L W) = L + edges W.
Proof. by elim: L => //= L IH; rewrite edges_longer IH. Qed.

Lemma at_end_vertices L W : vertices (at_end_of_path L W) = L + vertices W.
Proof. by elim: L => //= L IH; rewrite vertices_longer IH. Qed.

Lemma at_end_in_universe u L W : in_universe u W -> in_universe u (at_end_of_path L W).
Proof. by move=> U; elim: L => //= L IH; exact: longer_in_universe. Qed.

(* ---- 0, 1, ..., n in a circle ---- *)
Section Circle.
Variable n : nat.

Definition after (i : 'I_n.+1) : 'I_n.+1 := inord (i.+1 %% n.+1).

Lemma after_turn j (i : 'I_n.+1) : val (iter j after i) = (i + j) %% n.+1.
Proof.
elim: j => [|j IH]; first by rewrite addn0 modn_small.
by rewrite iterS /= inordK ?ltn_pmod // IH -addn1 modnDml addn1 addnS.
Qed.

Lemma after_full i : iter n.+1 after i = i.
Proof. by apply: val_inj; rewrite after_turn modnDr modn_small. Qed.

Lemma after_inj : injective after.
Proof. by move=> i j E; rewrite -(after_full i) -(after_full j) !iterSr E. Qed.

Lemma after_reaches (i j : 'I_n.+1) : iter (n.+1 - i + j) after i = j.
Proof.
by apply: val_inj; rewrite after_turn addnA subnKC ?(ltnW (ltn_ord i)) // modnDl modn_small.
Qed.
End Circle.

(* ---- One vertex with k+1 loops ---- *)
Section Bouquet.
Variable k : nat.

Local Notation bouquet_sigma := (@after k.*2.+1).

Lemma bouquet_all i j : fconnect bouquet_sigma i j.
Proof. by rewrite -(after_reaches i j); exact: fconnect_iter. Qed.

Lemma bouquet_alpha_neq (i : 'I_(k.*2.+2)) : rev_ord i != i.
Proof.
apply/eqP=> /(congr1 val) /= E; move: (ltn_ord i) E; move: (nat_of_ord i) => j lj E.
have : k.+1.*2 = j + j.+1 by rewrite doubleS -(subnK lj) E.
by move/(congr1 odd); rewrite odd_double addnS /= addnn odd_double.
Qed.

Lemma bouquet_connected i j : connect (adjacent bouquet_sigma (@rev_ord _)) i j.
Proof.
apply: connect_sub (bouquet_all i j) => a b /eqP <-.
by apply: connect1; rewrite /adjacent eqxx.
Qed.

Definition bouquet_map :=
  CombinatorialMap (@after_inj k.*2.+1) (@rev_ordK _) bouquet_alpha_neq bouquet_connected.
Definition bouquet := @LighthouseWorld bouquet_map ord0 ord0 (connect0 _ _).

Lemma edges_bouquet : edges bouquet = k.+1.
Proof. by apply: double_inj; rewrite edges_double card_ord. Qed.

Lemma vertices_bouquet : vertices bouquet = 1.
Proof.
rewrite /vertices /n_comp_mem (@eq_card _ _ (pred1 (froot (@sigma bouquet) ord0))) ?card1 //.
have sym := fconnect_sym (@sigma_inj bouquet).
move=> r; rewrite !inE andbT; apply/eqP/eqP=> [<-|->]; last first.
  by apply/eqP; rewrite (root_connect sym); exact: bouquet_all.
by apply/eqP; rewrite (root_connect sym); exact: bouquet_all.
Qed.
End Bouquet.

(* ---- The complete graph with k+3 vertices: dart j of vertex i leads to vertex i+j+1 ---- *)
Section Complete.
Variable k : nat.
Local Notation dart := ('I_k.+3 * 'I_k.+2)%type.

Definition complete_sigma (d : dart) : dart := (d.1, after d.2).
Definition complete_alpha (d : dart) : dart := (iter d.2.+1 (@after k.+2) d.1, rev_ord d.2).

Lemma complete_turn j d : iter j complete_sigma d = (d.1, iter j (@after k.+1) d.2).
Proof. by elim: j => [|j IH]; [case: d | rewrite iterS IH]. Qed.

Lemma complete_sigma_inj : injective complete_sigma.
Proof. by move=> [i j] [i' j'] [-> E]; rewrite (after_inj E). Qed.

Lemma complete_alphaK : involutive complete_alpha.
Proof.
case=> i j; rewrite /complete_alpha /= rev_ordK -!iterS -iterD; congr (_, _).
by rewrite (_ : _ + _ = k.+3) ?after_full // /= addSn subnK.
Qed.

(* the way from i leads elsewhere *)
Lemma complete_apart i (j : 'I_k.+2) : iter j.+1 (@after k.+2) i != i.
Proof.
apply/eqP=> /(congr1 val); rewrite after_turn => E; have lj := ltn_ord j.
have /eqP : i + j.+1 = i + 0 %[mod k.+3] by rewrite addn0 E modn_small.
by rewrite eqn_modDl mod0n modn_small.
Qed.

Lemma complete_alpha_neq d : complete_alpha d != d.
Proof. by case: d => i j; apply/eqP=> -[/eqP]; rewrite (negbTE (complete_apart i j)). Qed.

Lemma complete_vertex (x y : dart) : fconnect complete_sigma x y = (x.1 == y.1).
Proof.
apply/idP/eqP=> [/iter_findex <-|]; first by rewrite complete_turn.
case: x y => i j [_ j'] /= <-; rewrite -(after_reaches j j').
by have := fconnect_iter complete_sigma (k.+2 - j + j') (i, j); rewrite complete_turn.
Qed.

Lemma complete_next i i' : i <> i' -> exists j : 'I_k.+2, iter j.+1 (@after k.+2) i = i'.
Proof.
move=> ne; pose r := (k.+3 - i + i') %% k.+3; have lr : r < k.+3 by rewrite ltn_mod.
have E : iter r (@after k.+2) i = i'.
  by rewrite -[RHS](after_reaches i); apply: val_inj; rewrite !after_turn modnDmr.
case: r E lr => [//|r] E lr; by exists (Ordinal (lr : r < k.+2)).
Qed.

Lemma complete_connected x y : connect (adjacent complete_sigma complete_alpha) x y.
Proof.
set e := adjacent _ _; have round i j j' : connect e (i, j) (i, j').
  have : fconnect complete_sigma (i, j) (i, j') by rewrite complete_vertex.
  by apply: connect_sub => u v /eqP <-; apply: connect1; rewrite /e /adjacent eqxx.
case: x y => i j [i' j']; case: (i =P i') => [<-|/complete_next[j0 E]]; first exact: round.
apply: connect_trans (round i j j0) _; apply: (@connect_trans _ _ (i', rev_ord j0)); last exact: round.
by apply: connect1; rewrite /e /adjacent /complete_alpha /= -E eqxx orbT.
Qed.

Definition complete_map :=
  CombinatorialMap complete_sigma_inj complete_alphaK complete_alpha_neq complete_connected.
Definition complete := @LighthouseWorld complete_map (ord0, ord0) (ord0, ord0) (connect0 _ _).

Lemma complete_simple : simple_world complete.
Proof.
case=> i j [i' j']; rewrite /at_same_vertex !complete_vertex /= => /eqP <- /eqP/(congr1 val).
have lj := ltn_ord j; have lj' := ltn_ord j'; rewrite -!iterS !after_turn => /eqP.
by rewrite eqn_modDl !modn_small // => /eqP[E]; congr (_, _); exact: val_inj.
Qed.

Lemma edges_complete : edges complete = 'C(k.+3, 2).
Proof. by apply: double_inj; rewrite edges_double card_prod !card_ord -mul2n -mul_bin_diag bin1. Qed.

Lemma vertices_complete : vertices complete = k.+3.
Proof.
have two (d : complete) : order sigma d = k.+2.
  apply: order_least => //; first exact: complete_sigma_inj.
    by rewrite complete_turn after_full; case: d.
  move=> j /andP[j0 lj] /(congr1 (fun d : dart => val d.2)); rewrite complete_turn after_turn => E.
  have /eqP : d.2 + j = d.2 + 0 %[mod k.+2] by rewrite addn0 E modn_small.
  by rewrite eqn_modDl mod0n modn_small // eqn0Ngt j0.
apply/eqP; rewrite -(eqn_pmul2r (m := k.+2)) //; apply/eqP.
rewrite /vertices (fcard_order_set (n := k.+2) complete_sigma_inj) //; last first.
  by apply/subsetP=> d _; rewrite inE two.
by rewrite card_prod !card_ord.
Qed.
End Complete.

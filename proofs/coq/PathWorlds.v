(* ---------------------------------------------------------------------------------------------
   Families of worlds: any world at the end of a path; bouquets of loops.              Section VI

     longer W, at_end_of_path L W   W with an edge before v0; with L edges before it, v0 at their end.
     bouquet k            one vertex with k+1 loops.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Excursions.
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

Lemma vertices_longer : vertices longer = (vertices W).+1.
Proof.
pose vertex_of (x : longer) : option W :=
  match x with
  | inl d => Some (froot sigma d)
  | inr b => if b then Some (froot sigma v0) else None
  end.
have step (d : W) : froot sigma (sigma d) = froot sigma d.
  apply/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))) (fconnect_sym (@sigma_inj W)).
  exact: fconnect1.
have inv (x : longer) : vertex_of (sigma x) = vertex_of x.
  by case: x => [d|[]] //=; rewrite ?step //; case: eqP => [->|_] //=; rewrite step.
have inv_root (x : longer) : vertex_of (froot sigma x) = vertex_of x.
  rewrite -(iter_findex (connect_root _ x)).
  by elim: (findex _ _ _) => // k IH; rewrite iterS inv.
have sym := fconnect_sym (@sigma_inj longer).
have symW (d d' : W) : froot sigma d = froot sigma d' -> fconnect sigma d d'.
  by move/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))).
have sep (x y : longer) : vertex_of x = vertex_of y -> fconnect sigma x y.
  case: x y => [d|b] [d'|b'] /=.
  - by case=> /symW /longer_same.
  - case: b' => // E; apply: connect_trans longer_joined; apply: longer_same; apply: symW.
    by case: E.
  - case: b => // E; rewrite sym; apply: connect_trans longer_joined; apply: longer_same; apply: symW.
    by case: E.
  by case: b b' => [] [].
pose roots_of (G : combinatorial_map) : {set G} := [set r in froots (@sigma G)].
have card_roots (G : combinatorial_map) : vertices G = #|roots_of G|.
  by rewrite cardsE /vertices /n_comp_mem; apply: eq_card => r; rewrite !inE andbT.
have inj : {in roots_of longer &, injective vertex_of}.
  move=> x y; rewrite !inE => /eqP rx /eqP ry /sep.
  by rewrite -(root_connect sym) rx ry => /eqP.
rewrite (card_roots longer) -(card_in_imset inj) (card_roots W).
have -> : vertex_of @: roots_of longer = None |: Some @: roots_of W.
  apply/setP=> x; rewrite in_setU1; apply/imsetP/orP=> [[y ry ->]|].
    case: y ry => [d|[]] ry /=; [right | right | by left].
      by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
    by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
  case=> [/eqP->|/imsetP[r rr ->]].
    exists (froot sigma (inr false : longer)); last by rewrite inv_root.
    by rewrite inE; exact: (roots_root sym).
  exists (froot sigma (inl r : longer)); first by rewrite inE; exact: (roots_root sym).
  by rewrite inv_root /=; move: rr; rewrite inE => /eqP->.
rewrite cardsU1 card_imset; last by move=> u v [].
by have -> : None \notin Some @: roots_of W by apply/imsetP=> -[].
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

(* one vertex with k+1 loops *)
Section Bouquet.
Variable k : nat.

Definition bouquet_sigma (i : 'I_(k.*2.+2)) : 'I_(k.*2.+2) := inord (i.+1 %% k.*2.+2).

Lemma bouquet_val i : val (bouquet_sigma i) = i.+1 %% k.*2.+2.
Proof. by rewrite /= inordK // ltn_pmod. Qed.

Lemma bouquet_turn j i : val (iter j bouquet_sigma i) = (i + j) %% k.*2.+2.
Proof.
elim: j => [|j IH]; first by rewrite addn0 modn_small.
by rewrite iterS bouquet_val IH -addn1 modnDml addn1 addnS.
Qed.

Lemma bouquet_full i : iter k.*2.+2 bouquet_sigma i = i.
Proof. by apply: val_inj; rewrite bouquet_turn modnDr modn_small. Qed.

Lemma bouquet_sigma_inj : injective bouquet_sigma.
Proof. by move=> i j E; rewrite -(bouquet_full i) -(bouquet_full j) !iterSr E. Qed.

Lemma bouquet_all i j : fconnect bouquet_sigma i j.
Proof.
have -> : j = iter (k.*2.+2 - i + j) bouquet_sigma i.
  by apply: val_inj; rewrite bouquet_turn addnA subnKC ?(ltnW (ltn_ord i)) // modnDl modn_small.
exact: fconnect_iter.
Qed.

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
  CombinatorialMap bouquet_sigma_inj (@rev_ordK _) bouquet_alpha_neq bouquet_connected.
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


(* ---------------------------------------------------------------------------------------------
   Numbered maps: a decision procedure for sameness.                                          Section V

     validP, validI       the Boolean check of Model.v is wellformedness.
     dart_order M         the darts in the order of a breadth-first search from the root, sigma
                          before alpha; code M: the map renumbered in this order.
     same_code M N        the decision procedure: equal codes.  same_codeP: it decides `isomorphic`.
     connectedP           connectedness is decided by the same search.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model RootedMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Numbered maps ---- *)
Lemma validP M : valid M -> wellformed (denote M).
Proof.
case/and5P=> /eqP sa lr /allP As /allP Aa /andP[U /allP A]; split=> //= x.
- by move=> lx; apply/As/mem_nth.
- by move=> lx; apply/Aa/mem_nth; rewrite sa.
- by move=> y lx ly /eqP; rewrite nth_uniq // => /eqP.
- by move=> lx; apply/eqP; have /andP[] := A x (etrans (mem_iota 0 _ x) lx).
- by move=> lx; apply/eqP; have /andP[] := A x (etrans (mem_iota 0 _ x) lx).
Qed.

Lemma validI M : wellformed (denote M) -> size (alpha_list M) = size (sigma_list M) -> valid M.
Proof.
move=> W sz; rewrite /valid sz eqxx; apply/and5P; split=> //; try exact: (wellformed_root W).
- by apply/(all_nthP 0)=> i li; exact: (wellformed_sigma W).
- by apply/(all_nthP 0)=> i; rewrite sz => li; exact: (wellformed_alpha W).
apply/andP; split.
  by apply/(uniqP 0)=> i j li lj; exact: (wellformed_inj W).
apply/allP=> i; rewrite mem_iota /= => li; apply/andP; split; first exact/eqP/(wellformed_alphaK W).
exact/eqP/(wellformed_alpha_neq W).
Qed.

(* ---- The decision procedure ---- *)
Definition insert (x : nat) s := if x \in s then s else rcons s x.

Section BreadthFirst.
Variables sigma alpha : nat -> nat.

Fixpoint breadth_first fuel i found :=
  if fuel is fuel'.+1 then
    if i < size found then
      let d := nth 0 found i in
      breadth_first fuel' i.+1 (insert (alpha d) (insert (sigma d) found))
    else found
  else found.

Definition relabel found :=
  ([seq index (sigma d) found | d <- found], [seq index (alpha d) found | d <- found]).
End BreadthFirst.

Definition dart_order M :=
  breadth_first (nth 0 (sigma_list M)) (nth 0 (alpha_list M)) (size (sigma_list M)) 0
    [:: root_number M].
Definition code M := relabel (nth 0 (sigma_list M)) (nth 0 (alpha_list M)) (dart_order M).
Definition same_code M N :=
  [&& size (dart_order M) == size (sigma_list M), size (dart_order N) == size (sigma_list N)
    & code M == code N].

Lemma mem_insert x y s : (y \in insert x s) = (y == x) || (y \in s).
Proof. by rewrite /insert; case: ifP => [xs|_]; rewrite ?mem_rcons ?inE //; case: eqP => // ->. Qed.

Lemma insert_uniq x s : uniq (insert x s) = uniq s.
Proof. by rewrite /insert; case: ifP => // xs; rewrite rcons_uniq xs. Qed.

Lemma insert_nth x s i : i < size s -> nth 0 (insert x s) i = nth 0 s i.
Proof. by rewrite /insert; case: ifP => // _ l; rewrite nth_rcons l. Qed.

Lemma insert_size x s : size s <= size (insert x s).
Proof. by rewrite /insert; case: ifP => // _; rewrite size_rcons. Qed.

Section BreadthFirstFacts.
Variables (s a : nat -> nat) (n : nat).
Hypotheses (sn : forall x, x < n -> s x < n) (an : forall x, x < n -> a x < n).
Lemma breadth_first_darts fuel i ord : all (fun x => x < n) ord -> uniq ord ->
  all (fun x => x < n) (breadth_first s a fuel i ord) /\ uniq (breadth_first s a fuel i ord).
Proof.
elim: fuel i ord => //= f IH i ord A U; case: ifP => // li.
have ld : nth 0 ord i < n by apply: (allP A); exact: mem_nth.
apply: IH; last by rewrite !insert_uniq.
by apply/allP=> x; rewrite !mem_insert => /or3P[/eqP->|/eqP->|/(allP A)] //; auto.
Qed.

Lemma breadth_first_sub fuel i ord x : x \in ord -> x \in breadth_first s a fuel i ord.
Proof. by elim: fuel i ord => //= f IH i ord xo; case: ifP => // _; apply: IH;
  rewrite !mem_insert xo !orbT. Qed.
Lemma breadth_first_closed fuel i ord : all (fun x => x < n) ord -> uniq ord -> i <= size ord ->
  n <= fuel + i ->
  (forall j, j < i -> (s (nth 0 ord j) \in ord) && (a (nth 0 ord j) \in ord)) ->
  forall x, x \in breadth_first s a fuel i ord ->
    (s x \in breadth_first s a fuel i ord) && (a x \in breadth_first s a fuel i ord).
Proof.
have full o k x : k = size o -> x \in o ->
    (forall j, j < k -> (s (nth 0 o j) \in o) && (a (nth 0 o j) \in o)) -> (s x \in o) && (a x \in o).
  by move=> -> xo H; have := H (index x o); rewrite index_mem xo nth_index //; apply.
elim: fuel i ord => [|f IH] i ord A U li nf H x /=.
  move=> xo; apply: (full ord i) => //; apply/eqP; rewrite eqn_leq li /=.
  apply: leq_trans nf; rewrite -(size_iota 0 n); apply: uniq_leq_size => // y /(allP A).
  by rewrite mem_iota.
case: ifP => [lt|/negbT]; last first.
  by rewrite -leqNgt => le xo; apply: (full ord i) => //; apply/eqP; rewrite eqn_leq li.
have ld : nth 0 ord i < n by apply: (allP A); exact: mem_nth.
set d := nth 0 ord i in ld *; apply: IH.
- by apply/allP=> y; rewrite !mem_insert => /or3P[/eqP->|/eqP->|/(allP A)] //; auto.
- by rewrite !insert_uniq.
- by apply: leq_trans lt _; exact: leq_trans (insert_size _ _) (insert_size _ _).
- by rewrite addnS -addSn.
- move=> j; rewrite ltnS leq_eqVlt => /orP[/eqP->|lj].
    by rewrite !insert_nth ?(leq_trans lt (insert_size _ _)) // !mem_insert !eqxx !orbT.
  have lj' := ltn_trans lj lt; rewrite !insert_nth ?(leq_trans lj' (insert_size _ _)) // !mem_insert.
  by have /andP[-> ->] := H j lj; rewrite !orbT.
Qed.
End BreadthFirstFacts.
Section Equivariant.
Variables (s a s' a' f : nat -> nat) (n : nat).
Hypotheses (sn : forall x, x < n -> s x < n) (an : forall x, x < n -> a x < n).
Hypothesis fi : forall x y, x < n -> y < n -> f x = f y -> x = y.
Hypotheses (fs : forall x, x < n -> f (s x) = s' (f x)) (fa : forall x, x < n -> f (a x) = a' (f x)).
Lemma mem_image x o : x < n -> all (fun x => x < n) o -> (f x \in map f o) = (x \in o).
Proof.
move=> lx A; apply/mapP/idP=> [[y yo /fi E]|xo]; last by exists x.
by rewrite E // (allP A).
Qed.

Lemma index_image x o : x < n -> all (fun x => x < n) o -> index (f x) (map f o) = index x o.
Proof.
move=> lx; elim: o => //= y o IH /andP[ly A]; rewrite IH //.
by have -> : (f y == f x) = (y == x) by apply/eqP/eqP=> [/fi->|->].
Qed.

Lemma insert_image x o : x < n -> all (fun x => x < n) o -> insert (f x) (map f o) = map f (insert x o).
Proof. by move=> lx A; rewrite /insert mem_image //; case: ifP; rewrite ?map_rcons. Qed.

Lemma breadth_first_image fuel i o : all (fun x => x < n) o ->
  breadth_first s' a' fuel i (map f o) = map f (breadth_first s a fuel i o).
Proof.
elim: fuel i o => //= fl IH i o A; rewrite size_map; case: ifP => // li.
have ld : nth 0 o i < n by apply: (allP A); exact: mem_nth.
have A' : all (fun x => x < n) (insert (s (nth 0 o i)) o).
  by apply/allP=> x; rewrite mem_insert => /orP[/eqP->|/(allP A)] //; auto.
rewrite (nth_map 0) // -fs // -fa // !insert_image ?IH //; try by auto.
by apply/allP=> x; rewrite mem_insert => /orP[/eqP->|/(allP A')] //; auto.
Qed.

Lemma relabel_image o : all (fun x => x < n) o -> relabel s' a' (map f o) = relabel s a o.
Proof.
by move=> A; rewrite /relabel -!map_comp; congr (_, _); apply/eq_in_map => x /(allP A) lx /=;
  rewrite -?fs -?fa // index_image //; auto.
Qed.
End Equivariant.

Lemma dart_order_ok M : valid M -> all (fun x => x < size (sigma_list M)) (dart_order M) /\
  uniq (dart_order M).
Proof. by move/validP=> W; apply: breadth_first_darts => //=;
  [exact: (wellformed_sigma W)|exact: (wellformed_alpha W)|rewrite andbT;
    exact: (wellformed_root W)]. Qed.
Lemma dart_order_full M : valid M -> connected (denote M) -> size (dart_order M) = size (sigma_list M).
Proof.
move=> V C; have W := validP V; have [A U] := dart_order_ok V; apply/eqP; rewrite eqn_leq;
  apply/andP; split.
  rewrite -[X in _ <= X](size_iota 0); apply: uniq_leq_size => // y /(allP A).
  by rewrite mem_iota.
rewrite -[X in X <= _](size_iota 0); apply: uniq_leq_size; rewrite ?iota_uniq // => y.
rewrite mem_iota add0n /= => ly.
have cl x : x \in dart_order M ->
  (nth 0 (sigma_list M) x \in dart_order M) && (nth 0 (alpha_list M) x \in dart_order M).
  apply: (@breadth_first_closed _ _ (size (sigma_list M))) => //; rewrite ?addn0 //=.
  - exact: (wellformed_sigma W).
  - exact: (wellformed_alpha W).
  - by rewrite andbT; exact: (wellformed_root W).
apply: (C (fun x => x \in dart_order M)) => //.
- by apply: breadth_first_sub; rewrite inE.
- by move=> x _ /cl/andP[].
- by move=> x _ /cl/andP[].
Qed.

Lemma mem_dart_order M x : valid M -> size (dart_order M) = size (sigma_list M) ->
  (x \in dart_order M) = (x < size (sigma_list M)).
Proof.
move=> V E; have [A U] := dart_order_ok V.
have sub : {subset dart_order M <= iota 0 (size (sigma_list M))} by move=> y /(allP A);
  rewrite mem_iota.
have le : size (iota 0 (size (sigma_list M))) <= size (dart_order M) by rewrite size_iota E.
by have [_ ->] := uniq_min_size U sub le; rewrite mem_iota.
Qed.

Theorem same_code_sound M N : valid M -> valid N -> same_code M N -> isomorphic (denote M) (denote N).
Proof.
move=> VM VN /and3P[/eqP sM /eqP sN /eqP C].
have [AM UM] := dart_order_ok VM; have [AN UN] := dart_order_ok VN.
have oM x := mem_dart_order x VM sM; have oN x := mem_dart_order x VN sN.
move: C; rewrite /code /relabel => -[Cs Ca].
have sz : size (dart_order M) = size (dart_order N) by have := congr1 size Cs; rewrite !size_map.
have key (p q : nat -> nat) x : x < size (sigma_list M) ->
  (forall y, y < size (sigma_list N) -> q y < size (sigma_list N)) ->
   (forall y, y < size (sigma_list M) -> p y < size (sigma_list M)) ->
   [seq index (p d) (dart_order M) | d <- dart_order M] = [seq index (q d) (dart_order N) | d <-
     dart_order N] ->
   nth 0 (dart_order N) (index (p x) (dart_order M)) = q (nth 0 (dart_order N) (index x (dart_order
     M))).
  move=> lx Q P' E; have li : index x (dart_order M) < size (dart_order M) by rewrite index_mem oM.
  have := congr1 (fun l => nth 0 l (index x (dart_order M))) E.
  rewrite (nth_map 0) // (nth_map 0) -?sz // nth_index ?oM // => ->.
  by rewrite nth_index // oN; apply: Q; rewrite -oN; apply: mem_nth; rewrite -sz.
have WM := validP VM; have WN := validP VN.
have n0 o k : nth 0 o k = nth 0 o k by [].
exists (fun x => nth 0 (dart_order N) (index x (dart_order M))),
  (fun y => nth 0 (dart_order M) (index y (dart_order N))).
split=> /=.
- move=> x lx; have li : index x (dart_order M) < size (dart_order M) by rewrite index_mem oM.
  split; first by rewrite -oN; apply: mem_nth; rewrite -sz.
  + by rewrite index_uniq -?sz // nth_index ?oM.
  + by apply: key => //; [exact: (wellformed_sigma WN)|exact: (wellformed_sigma WM)].
  + by apply: key => //; [exact: (wellformed_alpha WN)|exact: (wellformed_alpha WM)].
- move=> y ly; have li : index y (dart_order N) < size (dart_order N) by rewrite index_mem oN.
  by rewrite -oM mem_nth ?sz //; rewrite index_uniq ?sz // nth_index ?oN.
- have hd K : valid K -> exists t, dart_order K = root_number K :: t.
    move=> VK; rewrite /dart_order; have := wellformed_root (validP VK); rewrite /=;
      case: (size _) => // n _ /=.
    set o := insert _ _; have [t ->] : exists t, o = root_number K :: t.
      by rewrite /o /insert /=; do 2 (case: ifP => _ /=); eexists.
    elim: n 1 t => [|n IH] i t /=; first by exists t.
    case: ifP => _; last by exists t.
    rewrite /insert /=; do 2 (case: ifP => _ /=); exact: IH.
  by have [t ->] := hd M VM; have [t' ->] := hd N VN; rewrite /= eqxx.
Qed.

Theorem same_code_complete M N : valid M -> valid N -> connected (denote M) ->
  isomorphic (denote M) (denote N) -> same_code M N.
Proof.
move=> VM VN C I; have [f [g [F G r]]] := I; have WM := validP VM; have WN := validP VN;
  rewrite /= in F G r.
have sM := dart_order_full VM C.
have fi x y : x < size (sigma_list M) -> y < size (sigma_list M) -> f x = f y -> x = y.
  by move=> lx ly E; have [_ <- _ _] := F _ lx; have [_ <- _ _] := F _ ly; rewrite E.
have sz : size (sigma_list N) = size (sigma_list M).
  have le (p q : nat -> nat) k l : (forall x, x < k -> p x < l) ->
    (forall x, x < k -> q (p x) = x) -> k <= l.
    move=> H K; rewrite -(size_iota 0 k) -(size_iota 0 l) -(size_map p); apply: uniq_leq_size.
      rewrite map_inj_in_uniq ?iota_uniq // => x y; rewrite !mem_iota /= => /K E /K E' pp.
      by rewrite -E pp E'.
    by move=> y /mapP[x]; rewrite !mem_iota /= => /H ? ->.
  apply/eqP; rewrite eqn_leq; apply/andP; split.
    by apply: (le g f) => x /G[].
  by apply: (le f g) => x /F[].
have oE : dart_order N = map f (dart_order M).
  rewrite /dart_order sz -r -[[:: f _]]/(map f [:: root_number M]).
  apply: (breadth_first_image (n := size (sigma_list M))) => //=.
  - exact: (wellformed_sigma WM).
  - exact: (wellformed_alpha WM).
  - by move=> x /F[].
  - by move=> x /F[].
  - by rewrite andbT; exact: (wellformed_root WM).
rewrite /same_code sM oE size_map sM sz !eqxx /=; apply/eqP; rewrite /code oE; symmetry.
have [A _] := dart_order_ok VM.
apply: (relabel_image (n := size (sigma_list M))) => //.
- exact: (wellformed_sigma WM).
- exact: (wellformed_alpha WM).
- by move=> x /F[].
- by move=> x /F[].
Qed.

Theorem same_codeP M N : valid M -> valid N -> connected (denote M) ->
  reflect (isomorphic (denote M) (denote N)) (same_code M N).
Proof. by move=> VM VN C; apply: (iffP idP); [exact: same_code_sound|exact: same_code_complete]. Qed.

(* connectedness is decided by the same search *)
Theorem connectedP M : valid M ->
  reflect (connected (denote M)) (size (dart_order M) == size (sigma_list M)).
Proof.
move=> V; apply: (iffP eqP); last exact: dart_order_full.
move=> E A A0 As Aa x /= lx; have : x \in dart_order M by rewrite mem_dart_order.
have W := validP V.
have H fuel i o : (forall y, y \in o -> y < size (sigma_list M) /\ A y) ->
    forall y, y \in breadth_first (nth 0 (sigma_list M)) (nth 0 (alpha_list M)) fuel i o -> A y.
  elim: fuel i o => [|f IH] i o Ho y /=; first by case/Ho.
  case: ifP => [li|_]; last by case/Ho.
  apply: IH => z; rewrite !mem_insert; have [ld Ad] := Ho _ (mem_nth 0 li).
  case/or3P=> [/eqP->|/eqP->|/Ho//]; split.
  - exact: (wellformed_alpha W).
  - exact: Aa.
  - exact: (wellformed_sigma W).
  - exact: As.
by apply: H => y; rewrite inE => /eqP->; split=> //; exact: (wellformed_root W).
Qed.

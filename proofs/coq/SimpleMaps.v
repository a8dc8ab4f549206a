(* ---------------------------------------------------------------------------------------------
   The simple rooted maps with m edges, without going through all the others.          Section III

   The tree of Enumeration.v, from which a branch is cut as soon as what has been decided shows a loop
   or two edges with the same ends.  What has been decided of sigma says of some darts that they lie at
   one vertex; the darts are labelled so that such darts have equal labels.

     cycle_labels n f     the labels, by CongruenceProgram.merge: i and the i-th entry of f get the same.
     cycle_count, planar_in   how many labels there are, and so: whether a map is planar.
     may_be_simple labels a   no edge decided by a has two darts with equal labels, and no two of them
                          the same labels.
     kept                 codes of Enumeration.v, with the branches cut off.
     simple_maps m        the simple ones among them.

     simple_maps_complete every simple member of rooted_maps m is in the list.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes NumberedWorlds Enumeration Twins.
From Allworlds Require Import CongruenceProgram Cluster SameWorld.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition cycle_labels n (f : seq nat) := foldl merge (iota 0 n) (zip (iota 0 (size f)) f).
Definition cycle_count n f := count (fun p => p.1 == p.2) (zip (iota 0 n) (cycle_labels n f)).
Definition planar_in M :=
  let n := size (sigma_list M) in
  let phi := [seq nth 0 (sigma_list M) (nth 0 (alpha_list M) d) | d <- iota 0 n] in
  cycle_count n (sigma_list M) + cycle_count n phi == edges_in M + 2.

Definition may_be_simple (labels a : seq nat) :=
  let edges := [seq (nth 0 labels p.1, nth 0 labels p.2)
               | p <- zip (iota 0 (size a)) a & p.1 < p.2] in
  all (fun p => p.1 != p.2) edges && uniq (edges ++ [seq (p.2, p.1) | p <- edges]).

Section Tree.
Variable n : nat.

(* labels: those of s *)
Fixpoint kept fuel c s a labels : seq (seq nat * seq nat) :=
  if fuel is fuel'.+1 then
    if size s < c then
      flatten [seq let labels' := merge labels (size s, x) in
                   flatten [seq let a' := rcons a y in
                                if may_be_simple labels' a'
                                then kept fuel' (maxn (maxn c x.+1) y.+1) (rcons s x) a' labels'
                                else [::]
                           | y <- alpha_choices n (maxn c x.+1) a]
              | x <- sigma_choices n c s]
    else [::]
  else [:: (s, a)].
End Tree.

Definition simple_maps m : seq numbered_map :=
  [seq M <- [seq NumberedMap t.1 t.2 0 | t <- kept m.*2 m.*2 1 [::] [::] (iota 0 m.*2)]
    | valid M && canonical M].

(* ---- Equal labels lie on one cycle ---- *)
Section Labels.
Variables (n : nat) (F : 'I_n -> 'I_n) (f : seq nat).
Hypotheses (size_f : size f <= n) (fE : forall i : 'I_n, i < size f -> nth 0 f i = F i).
Hypothesis F_inj : injective F.
Local Notation labels := (cycle_labels n f).

Lemma graph_pairs p : p \in zip (iota 0 (size f)) f -> p.1 < size f /\ p.2 = nth 0 f p.1.
Proof.
case/(nthP (0, 0))=> j; rewrite size_zip size_iota minnn => lj <-.
by rewrite nth_zip ?size_iota //= nth_iota // add0n.
Qed.

Lemma graph_steps p : p \in zip (iota 0 (size f)) f -> exists2 x : 'I_n, p = (val x, val (F x)) & x < size f.
Proof.
case/graph_pairs=> l E; exists (Ordinal (leq_trans l size_f)) => //=.
by rewrite -fE // [LHS]surjective_pairing E.
Qed.

Lemma graph_range : all (in_range n) (zip (iota 0 (size f)) f).
Proof. by apply/allP=> p /graph_steps[x -> _]; rewrite /in_range !ltn_ord. Qed.

Lemma iota_least : least_labels n (iota 0 n).
Proof. by split; [exact: size_iota | move=> i li; rewrite nth_iota // add0n nth_iota]. Qed.

Lemma cycle_labels_least : least_labels n labels.
Proof. exact: (merges_least graph_range iota_least). Qed.

Definition label_of (x : 'I_n) : 'I_n := Ordinal (label_small cycle_labels_least (ltn_ord x)).

Lemma label_on_cycle x : fconnect F x (label_of x).
Proof.
pose R i j := exists u v : 'I_n, [/\ val u = i, val v = j & fconnect F u v].
suff [u [v [/val_inj <- E c]]] : R (val x) (nth 0 labels (val x)).
  by rewrite (_ : label_of u = v) //; exact: val_inj.
apply: (@merges_sound n _ graph_range R) => //.
- by move=> i j [u [v [uE vE c]]]; exists v, u; split=> //; rewrite (fconnect_sym F_inj).
- move=> j i k [u [v [uE vE c]]] [v' [w [vE' wE c']]]; exists u, w; split=> //.
  by apply: connect_trans c _; have -> : v = v' by apply: val_inj; rewrite vE vE'.
- exact: iota_least.
- by move=> p /graph_steps[u -> _]; exists u, (F u); split=> //; exact: fconnect1.
- by move=> i li; rewrite nth_iota //; exists (Ordinal li), (Ordinal li); split=> //; exact: connect0.
exact: ltn_ord.
Qed.

Lemma equal_labels_cycle x y : nth 0 labels (val x) = nth 0 labels (val y) -> fconnect F x y.
Proof.
move=> E; apply: connect_trans (label_on_cycle x) _.
have -> : label_of x = label_of y by exact: val_inj.
by rewrite (fconnect_sym F_inj); exact: label_on_cycle.
Qed.

Hypothesis full : size f = n.

Lemma label_of_cycle x y : fconnect F x y -> label_of x = label_of y.
Proof.
move/iter_findex <-; elim: (findex _ _ _) => //= k ->; apply: val_inj => /=; set z := iter k F x.
apply: (merges_merge graph_range iota_least (p := (val z, val (F z)))).
have <- : nth 0 f (val z) = val (F z) by rewrite fE ?full.
apply/(nthP (0, 0)); exists (val z); first by rewrite size_zip size_iota minnn full ltn_ord.
by rewrite nth_zip ?size_iota // nth_iota ?full ?ltn_ord.
Qed.

Theorem cycle_countE : fcard F 'I_n = cycle_count n f.
Proof.
rewrite (fcard_chosen F_inj label_on_cycle label_of_cycle) /cycle_count.
have sz : size labels = n by case: cycle_labels_least.
have -> : zip (iota 0 n) labels = [seq (i, nth 0 labels i) | i <- iota 0 n].
  apply: (@eq_from_nth _ (0, 0)); rewrite size_zip sz size_iota minnn ?size_map ?size_iota // => i li.
  by rewrite nth_zip ?size_iota ?sz // (nth_map 0) ?size_iota // nth_iota.
rewrite count_map -sum1_count -sum1_card.
have -> : iota 0 n = index_iota 0 n by rewrite /index_iota subn0.
rewrite big_mkord; apply: eq_bigl => i; rewrite !inE eq_sym.
by apply/eqP/eqP=> [/(congr1 val) //|E]; exact: val_inj.
Qed.
End Labels.

(* ---- What is cut off is not simple ---- *)
Section Simple.
Variables (M : numbered_map) (V : valid M) (C : connected (denote M)).
Local Notation G := (in_numbers V C).
Local Notation n := (size (sigma_list M)).
Local Notation s := (sigma_list M).
Local Notation a := (alpha_list M).
Let wf := validP V.
Let size_a : size a = n. Proof. by case/and5P: V => /eqP. Qed.

Theorem planar_inP : reflect (planar_map G) (planar_in M).
Proof.
have fi : injective (fun d : G => sigma (alpha d)) by move=> x y /sigma_inj /alpha_inj.
rewrite /planar_in -(edges_in_numbers V C); set phi := [seq _ | d <- _].
have <- : vertices G = cycle_count n s.
  exact: (@cycle_countE n (@sigma G) s (leqnn n) (fun _ _ => erefl) (@sigma_inj G) erefl).
have <- : faces G = cycle_count n phi; last exact: eqP.
apply: (@cycle_countE n (fun d : G => sigma (alpha d))); rewrite ?size_map ?size_iota //.
by move=> i li; rewrite (nth_map 0) ?size_iota // nth_iota.
Qed.

Hypothesis simple_G : simple_world G.

Lemma in_take j k (l : seq nat) : j < size (take k l) -> j < k /\ j < size l.
Proof.
by rewrite size_take; case: (ltnP k (size l)) => [lk lj|le lj]; split=> //;
  [exact: ltn_trans lj lk | exact: leq_trans lj le].
Qed.

Lemma equal_labels k (x y : G) : let labels := cycle_labels n (take k s) in
  nth 0 labels (val x) = nth 0 labels (val y) -> at_same_vertex x y.
Proof.
have le : size (take k s) <= n by rewrite size_take; case: ltnP => // /ltnW.
have fE (i : 'I_n) : i < size (take k s) -> nth 0 (take k s) i = @sigma G i.
  by case/in_take=> ik _; rewrite nth_take.
exact: (equal_labels_cycle le fE (@sigma_inj G)).
Qed.

Lemma simple_may_be k : k <= n -> may_be_simple (cycle_labels n (take k s)) (take k a).
Proof.
move=> kn; rewrite /may_be_simple; set labels := cycle_labels _ _; set ps := [seq p <- _ | _].
have psP p : p \in ps -> exists2 x : G, p = (val x, val (alpha x)) & p.1 < p.2.
  rewrite mem_filter => /andP[lt /graph_pairs[/in_take[lk l1] E]]; rewrite size_a in l1.
  by exists (Ordinal l1) => //; rewrite [LHS]surjective_pairing E nth_take.
have no_loop (x : G) : nth 0 labels (val x) != nth 0 labels (val (alpha x)).
  apply/eqP=> /equal_labels c; case/eqP: (alpha_neq x); apply/esym/(simple_G c).
  by rewrite alphaK at_same_vertex_sym.
have same_ends (x y : G) : nth 0 labels (val x) = nth 0 labels (val y) ->
    nth 0 labels (val (alpha x)) = nth 0 labels (val (alpha y)) -> x = y.
  by move=> /equal_labels c /equal_labels c'; exact: simple_G.
have u_ps : uniq ps.
  apply: filter_uniq; apply: (@map_uniq _ _ fst).
  rewrite -[map fst _]/(unzip1 _) unzip1_zip ?iota_uniq //.
  by rewrite size_iota.
apply/andP; split; first by apply/allP=> _ /mapP[_ /psP[x -> _] ->]; exact: no_loop.
rewrite -map_comp cat_uniq map_inj_in_uniq; last first.
  by move=> _ _ /psP[x -> _] /psP[y -> _] [/same_ends E /E ->].
rewrite u_ps map_inj_in_uniq ?u_ps ?andbT; last first.
  by move=> _ _ /psP[x -> _] /psP[y -> _] [E' E]; rewrite (same_ends x y E E').
apply/hasPn=> _ /mapP[_ /psP[x -> lx] ->]; apply/negP=> /mapP[_ /psP[y -> ly] [E' E]].
have xy : alpha x = y by apply: same_ends; rewrite ?alphaK.
by rewrite -xy alphaK /= in lx ly; have := ltn_trans lx ly; rewrite ltnn.
Qed.
End Simple.

(* ---- The list is complete ---- *)
Section Kept.
Variable n : nat.

Lemma codes_take fuel c s a t : t \in codes n fuel c s a ->
  take (size s) t.1 = s /\ take (size a) t.2 = a.
Proof.
elim: fuel c s a => [|fuel IH] c s a /=; first by rewrite inE => /eqP->; rewrite !take_size.
case: ifP => // _ /flattenP[_ /mapP[x _ ->]] /flattenP[_ /mapP[y _ ->]] /IH[].
rewrite !size_rcons => E1 E2.
by rewrite -(take_take (leqnSn (size s)) t.1) E1 -(take_take (leqnSn (size a)) t.2) E2 -!cats1
  !take_size_cat.
Qed.

Lemma cycle_labels_rcons s x :
  cycle_labels n (rcons s x) = merge (cycle_labels n s) (size s, x).
Proof.
rewrite /cycle_labels size_rcons -addn1 iotaD /= add0n -cats1 zip_cat ?size_iota //.
by rewrite foldl_cat.
Qed.

Lemma kept_codes fuel c s a t : size a = size s ->
  (forall k, k <= size s + fuel -> may_be_simple (cycle_labels n (take k t.1)) (take k t.2)) ->
  t \in codes n fuel c s a -> t \in kept n fuel c s a (cycle_labels n s).
Proof.
elim: fuel c s a => // fuel IH c s a sz H /=; case: ifP => // _.
case/flattenP=> _ /mapP[x mx ->] /flattenP[_ /mapP[y my ->]] mt.
apply/flattenP; eexists; first exact: map_f mx.
apply/flattenP; eexists; first exact: map_f my.
have [E1 E2] := codes_take mt; rewrite !size_rcons in E1 E2.
have := H (size s).+1; rewrite E1 -sz E2 sz addnS ltnS leq_addr cycle_labels_rcons => /(_ isT) ->.
by rewrite -cycle_labels_rcons; apply: IH; rewrite ?size_rcons ?sz // addSnnS.
Qed.
End Kept.

Theorem simple_maps_complete m M : M \in rooted_maps m -> simple M -> M \in simple_maps m.
Proof.
move=> lM sM; have [V C sz] := rooted_maps_sound lM; have [_ K] := listed lM.
rewrite mem_filter V K /=; move: lM; rewrite mem_filter => /andP[_ /mapP[t mt E]].
apply/mapP; exists t => //; apply: (@kept_codes _ _ _ [::]) => // k le.
have G := elimT (simple_in_numbers V C) sM.
by have := @simple_may_be M V C G k; rewrite sz E /=; apply.
Qed.

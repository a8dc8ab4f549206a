(* ---------------------------------------------------------------------------------------------
   The least congruence, computed.                                                 Sections IV, V

   The darts are 0 .. n-1.  A list c of labels says which of them are known to be the same: c holds for
   each dart the least dart that it is known to be the same as.  Whatever must be the same and has
   different labels yet is merged, until nothing is left to be merged.

     next, links, marked  the program's data: the next dart of each dart; the pairs of darts that are the
                          two ends of an edge, each pair in both orders; the darts that must be one.
     forced c             pairs that must be the same if c is right; they entail all others.
     merge c p            the two classes of the pair p made one, under the lesser label.
     closure, classes     merged until all forced pairs have equal labels.
     settled_in c x       a dart of the class of x is an end of a pair.

     classes_same         on a finite type whose elements are numbered, and whose successor, links and
                          marks the data say: equal labels, if and only if related by the least
                          congruence of Congruence.v.
     settled_in_settled   settled_in is `settled`.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Congruence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The program ---- *)
Definition merge (c : seq nat) (p : nat * nat) :=
  let a := nth 0 c p.1 in let b := nth 0 c p.2 in
  if a == b then c else let least := minn a b in let other := maxn a b in
  [seq if l == other then least else l | l <- c].

(* the other end of the first link that begins in the class *)
Definition first_end (heads : seq (nat * nat)) label :=
  (nth (0, 0) heads (find (fun h => h.1 == label) heads)).2.

Section Program.
Variables (next : seq nat) (links : seq (nat * nat)) (marked : seq nat).

Definition forced (c : seq nat) :=
  [seq (head 0 marked, x) | x <- marked] ++
  [seq (nth 0 next x, nth 0 next (nth 0 c x)) | x <- iota 0 (size c)] ++
  (let heads := [seq (nth 0 c l.1, l.2) | l <- links] in
   [seq (h.2, first_end heads h.1) | h <- heads]).

Fixpoint closure fuel c :=
  if fuel is fuel'.+1 then
    let c' := foldl merge c (forced c) in if c' == c then c else closure fuel' c'
  else c.

(* each round makes the sum of the labels smaller *)
Definition classes := let c := iota 0 (size next) in closure (sumn c).+1 c.

Definition settled_in c x := let label := nth 0 c x in has (fun l => nth 0 c l.1 == label) links.
End Program.

(* ---- Merging ---- *)
Section Merging.
Variable n : nat.

Definition in_range (p : nat * nat) := (p.1 < n) && (p.2 < n).
Definition least_labels c := size c = n /\
  forall x, x < n -> nth 0 c x <= x /\ nth 0 c (nth 0 c x) = nth 0 c x.

Lemma label_small c x : least_labels c -> x < n -> nth 0 c x < n.
Proof. by case=> _ H lx; have [le _] := H x lx; exact: leq_ltn_trans lx. Qed.

Lemma merge_label c p x : x < size c -> nth 0 (merge c p) x =
  let a := nth 0 c p.1 in let b := nth 0 c p.2 in
  if nth 0 c x == maxn a b then minn a b else nth 0 c x.
Proof.
rewrite /merge /=; case: eqP => [E|_] lx; last by rewrite (nth_map 0).
by rewrite E maxnn minnn; case: eqP.
Qed.

Lemma size_merge c p : size (merge c p) = size c.
Proof. by rewrite /merge; case: eqP => //; rewrite size_map. Qed.

Lemma merge_least c p : in_range p -> least_labels c -> least_labels (merge c p).
Proof.
case/andP=> l1 l2 G; have [s H] := G; split; first by rewrite size_merge.
have sm y (ly : y < n) := label_small G ly; have [_ c1] := H _ l1; have [_ c2] := H _ l2.
have mE y : y < n -> _ := fun ly => @merge_label c p y (etrans (f_equal _ s) ly).
set a := nth 0 c p.1 in c1 mE; set b := nth 0 c p.2 in c2 mE; rewrite /= in mE.
have mn : minn a b < n by rewrite /minn; case: ifP => _; exact: sm.
have cm : nth 0 c (minn a b) = minn a b by rewrite /minn; case: ifP.
move=> x lx; have [le cc] := H x lx; rewrite (mE x) //; case: (_ =P maxn a b) => [E|ne].
  rewrite mE // cm; split; last by case: eqP.
  by apply: leq_trans le; rewrite E geq_min leq_max leqnn.
by rewrite mE ?sm // cc; split=> //; case: eqP.
Qed.

Lemma merge_keeps c p x y : x < size c -> y < size c -> nth 0 c x = nth 0 c y ->
  nth 0 (merge c p) x = nth 0 (merge c p) y.
Proof. by move=> lx ly E; rewrite !merge_label // E. Qed.

Lemma merge_merges c p : p.1 < size c -> p.2 < size c ->
  nth 0 (merge c p) p.1 = nth 0 (merge c p) p.2.
Proof.
move=> l1 l2; rewrite !merge_label //=; set a := nth 0 c p.1; set b := nth 0 c p.2.
by rewrite /maxn /minn; case: (ltngtP a b) => // [ab|ba|->]; rewrite ?eqxx ?ltn_eqF ?gtn_eqF.
Qed.

(* the sum of the labels falls, unless nothing is merged *)
Lemma merge_sum c p : p.1 < size c -> p.2 < size c ->
  sumn (merge c p) <= sumn c /\ (sumn (merge c p) = sumn c -> merge c p = c).
Proof.
move=> l1 l2; rewrite /merge; set a := nth 0 c p.1; set b := nth 0 c p.2.
case: eqP => [//|/eqP ne]; set g := fun l => _.
have lt : minn a b < maxn a b by rewrite leq_max !gtn_min !ltnn /= orbF; case: ltngtP ne.
have gl l : g l <= l by rewrite /g; case: eqP => [->|//]; exact: ltnW.
have le s : sumn [seq g l | l <- s] <= sumn s by elim: s => //= l s IH; exact: leq_add.
split=> // E; suff : sumn [seq g l | l <- c] < sumn c by rewrite E ltnn.
have: maxn a b \in c by rewrite /maxn; case: ifP => _; exact: mem_nth.
elim: (c) => //= l s IH; rewrite inE => /orP[/eqP<-|/IH lts]; last by rewrite -addnS leq_add.
by rewrite -addSn leq_add // /g eqxx.
Qed.

Section Fold.
Variable ds : seq (nat * nat).
Hypothesis range : all in_range ds.

Lemma merges_least c : least_labels c -> least_labels (foldl merge c ds).
Proof.
by elim: ds range c => //= p s IH /andP[rp rs] c G; apply: IH => //; exact: merge_least.
Qed.

Lemma merges_sum c : least_labels c -> sumn (foldl merge c ds) <= sumn c /\
  (sumn (foldl merge c ds) = sumn c ->
   foldl merge c ds = c /\ forall p, p \in ds -> nth 0 c p.1 = nth 0 c p.2).
Proof.
elim: ds range c => [|p s IH] /= => [_ c _|/andP[rp rs] c G]; first by split.
have [sz _] := G; have /andP[l1 l2] := rp; rewrite -sz in l1 l2.
have [le1 fix1] := merge_sum l1 l2; have [le2 fix2] := IH rs _ (merge_least rp G).
split=> [|E]; first exact: leq_trans le2 le1.
have E1 : sumn (merge c p) = sumn c by apply/eqP; rewrite eqn_leq le1 -{1}E.
have mE := fix1 E1; rewrite mE in fix2 E *; have [-> H] := fix2 E; split=> // q.
by rewrite inE => /orP[/eqP->|/H//]; have := merge_merges l1 l2; rewrite mE.
Qed.

(* what has been merged stays so *)
Lemma merges_merge c p : least_labels c -> p \in ds ->
  nth 0 (foldl merge c ds) p.1 = nth 0 (foldl merge c ds) p.2.
Proof.
have keep s d x y : x < size d -> y < size d -> nth 0 d x = nth 0 d y ->
    nth 0 (foldl merge d s) x = nth 0 (foldl merge d s) y.
  elim: s d => //= q s IH d lx ly E; apply: IH; rewrite ?size_merge //; exact: merge_keeps.
elim: ds range c => //= q s IH /andP[rq rs] c G; rewrite inE; case: eqP => [->|_] /= m.
  have [sz _] := G; have /andP[l1 l2] := rq; rewrite -sz in l1 l2.
  by apply: keep; rewrite ?size_merge //; exact: merge_merges.
by apply: IH => //; exact: merge_least.
Qed.

(* what is merged is related by every equivalence that relates the pairs *)
Variable R : nat -> nat -> Prop.
Hypotheses (R_sym : forall x y, R x y -> R y x) (R_trans : forall y x z, R x y -> R y z -> R x z).

Lemma merges_sound c : least_labels c -> (forall p, p \in ds -> R p.1 p.2) ->
  (forall x, x < n -> R x (nth 0 c x)) -> forall x, x < n -> R x (nth 0 (foldl merge c ds) x).
Proof.
elim: ds range c => //= p s IH /andP[rp rs] c G H Rc; have /andP[l1 l2] := rp.
apply: IH => // [|q m|x lx]; [exact: merge_least | by apply: H; rewrite inE m orbT |].
have [sz _] := G; rewrite merge_label ?sz //=; case: eqP => [E|_]; last exact: Rc.
apply: R_trans (Rc x lx) _; rewrite E; have Rp := H p (mem_head _ _).
have Rab : R (nth 0 c p.1) (nth 0 c p.2).
  by apply: R_trans (R_sym (Rc _ l1)) _; apply: R_trans Rp (Rc _ l2).
by rewrite /maxn /minn; case: ifP => _; [exact: R_sym | exact: Rab].
Qed.
End Fold.
End Merging.

(* ---- The labels at the end ---- *)
Section Classes.
Variables (next : seq nat) (links : seq (nat * nat)) (marked : seq nat).
Local Notation n := (size next).
Local Notation forced := (forced next links marked).
Hypotheses (next_range : all (gtn n) next) (links_range : all (in_range n) links).
Hypothesis marked_range : all (gtn n) marked.

Lemma next_small x : x < n -> nth 0 next x < n.
Proof. by move=> lx; apply: (allP next_range); exact: mem_nth. Qed.

Definition heads c := [seq (nth 0 c l.1, l.2) | l <- links].

Lemma first_endP c l : l \in links -> exists k,
  [/\ k \in links, nth 0 c k.1 = nth 0 c l.1 & k.2 = first_end (heads c) (nth 0 c l.1)].
Proof.
move=> ml; set label := nth 0 c l.1.
have h : has (fun h => h.1 == label) (heads c).
  by apply/hasP; exists (label, l.2) => //; apply: (map_f (fun l => (nth 0 c l.1, l.2))).
have /mapP[k mk E] : nth (0, 0) (heads c) (find (fun h => h.1 == label) (heads c)) \in heads c.
  by rewrite mem_nth // -has_find.
by exists k; have /eqP := nth_find (0, 0) h; rewrite /first_end E.
Qed.

Lemma forcedP c p : size c = n -> p \in forced c <-> [\/ exists2 x, x \in marked & p = (head 0 marked, x),
  exists2 x, x < n & p = (nth 0 next x, nth 0 next (nth 0 c x)) |
  exists2 l, l \in links & p = (l.2, first_end (heads c) (nth 0 c l.1))].
Proof.
move=> sz; rewrite !mem_cat; split=> [/or3P[/mapP[x m ->]|/mapP[x]|/mapP[_ /mapP[l ml ->] ->]]|].
- by constructor 1; exists x.
- by rewrite mem_iota sz => lx ->; constructor 2; exists x.
- by constructor 3; exists l.
case=> [[x m ->]|[x lx ->]|[l ml ->]]; apply/or3P.
- by constructor 1; apply: (map_f (fun x => (head 0 marked, x))).
- by constructor 2; apply: (map_f (fun x => (_ x, _))); rewrite mem_iota sz.
constructor 3; apply: (map_f (fun h => (h.2, first_end (heads c) h.1)) (x := (nth 0 c l.1, l.2))).
exact: (map_f (fun l => (nth 0 c l.1, l.2))).
Qed.

Lemma forced_range c : least_labels n c -> all (in_range n) (forced c).
Proof.
move=> G; apply/allP=> p /(forcedP _ G.1).
have h x : x \in marked -> x < n by move/(allP marked_range).
case=> [[x m ->]|[x lx ->]|[l ml ->]]; rewrite /in_range /=.
- by rewrite (h x m) h //; case: (marked) m => //= y s _; exact: mem_head.
- by rewrite !next_small // (label_small G).
have [k [mk _ <-]] := first_endP c ml.
by have /andP[_ ->] := allP links_range _ ml; have /andP[_ ->] := allP links_range _ mk.
Qed.

(* the labels are right: nothing more is forced *)
Definition saturated c := forall p, p \in forced c -> nth 0 c p.1 = nth 0 c p.2.

Lemma closureP fuel c : least_labels n c -> sumn c < fuel ->
  least_labels n (closure next links marked fuel c) /\ saturated (closure next links marked fuel c).
Proof.
elim: fuel c => // fuel IH c G lt /=; have F := forced_range G.
have [le fixed] := merges_sum F G; case: eqP => [E|ne].
  by split=> //; have [|] := fixed; rewrite ?E.
apply: IH; first exact: merges_least.
rewrite -ltnS; apply: leq_ltn_trans lt; rewrite ltn_neqAle le andbT.
by apply/eqP=> E; apply: ne; have [->] := fixed E.
Qed.

Lemma closure_sound (R : nat -> nat -> Prop) :
  (forall x y, R x y -> R y x) -> (forall y x z, R x y -> R y z -> R x z) ->
  (forall c, least_labels n c -> (forall x, x < n -> R x (nth 0 c x)) ->
     forall p, p \in forced c -> R p.1 p.2) ->
  forall fuel c, least_labels n c -> (forall x, x < n -> R x (nth 0 c x)) ->
  forall x, x < n -> R x (nth 0 (closure next links marked fuel c) x).
Proof.
move=> Rs Rt Rf; elim=> //= fuel IH c G Rc; case: eqP => // _.
have F := forced_range G; apply: IH; first exact: merges_least.
by apply: merges_sound => //; exact: Rf.
Qed.

Lemma least_iota : least_labels n (iota 0 n).
Proof. by split; [exact: size_iota | move=> x lx; rewrite nth_iota // add0n nth_iota]. Qed.
End Classes.

Arguments forcedP {next links marked c p} sz.

(* ---- On a finite type whose elements are numbered ---- *)
Section Numbered.
Variables (D : finType) (nextD : D -> D) (linkedD : rel D) (markedD : pred D) (number : D -> nat).
Variables (next : seq nat) (links : seq (nat * nat)) (marked : seq nat).
Local Notation n := (size next).
Hypotheses (number_inj : injective number) (number_small : forall x, number x < n).
Hypothesis number_onto : forall i, i < n -> exists x, number x = i.
Hypothesis next_number : forall x, nth 0 next (number x) = number (nextD x).
Hypothesis links_number : forall x y, linkedD x y <-> (number x, number y) \in links.
Hypothesis links_small : all (in_range n) links.
Hypothesis marked_number : forall x, markedD x <-> number x \in marked.
Hypothesis marked_small : all (gtn n) marked.
Local Notation same := (same nextD linkedD markedD).
Local Notation c := (classes next links marked).

Let next_range : all (gtn n) next.
Proof.
apply/allP=> i /(nthP 0)[j lj <-]; have [x <-] := number_onto lj; rewrite next_number /=.
exact: number_small.
Qed.

Let final : least_labels n c /\ saturated next links marked c.
Proof. by apply: closureP => //; exact: least_iota. Qed.

Lemma classes_least : least_labels n c.
Proof. by case: final. Qed.

Lemma linkedE i j : (i, j) \in links -> exists x y, [/\ number x = i, number y = j & linkedD x y].
Proof.
move=> m; have /andP[li lj] := allP links_small _ m.
have [x xE] := number_onto li; have [y yE] := number_onto lj; exists x, y.
by split=> //; apply/links_number; rewrite xE yE.
Qed.

Lemma markedE i : i \in marked -> exists2 x, number x = i & markedD x.
Proof.
move=> m; have [x xE] := number_onto (allP marked_small _ m); exists x => //.
by apply/marked_number; rewrite xE.
Qed.

Let Cg := same_congruence nextD linkedD markedD.
Let refl := congruence_refl Cg.
Let sym := congruence_sym Cg.
Let trans := congruence_trans Cg.

(* darts with equal labels are the same *)
Definition same_numbers i j := exists u v, [/\ number u = i, number v = j & same u v].

Lemma same_numbersE x y : same_numbers (number x) (number y) -> same x y.
Proof. by case=> u [v [/number_inj <- /number_inj <-]]. Qed.

Lemma same_numbers_sym i j : same_numbers i j -> same_numbers j i.
Proof. by case=> u [v [uE vE s]]; exists v, u; split=> //; exact: sym. Qed.

Lemma same_numbers_trans j i k : same_numbers i j -> same_numbers j k -> same_numbers i k.
Proof.
case=> u [v [uE vE s]] [v' [w [vE' wE s']]]; exists u, w; split=> //.
have ev : v' = v by apply: number_inj; rewrite vE vE'.
by rewrite ev in s'; exact: trans s s'.
Qed.

Lemma forced_same d : least_labels n d -> (forall i, i < n -> same_numbers i (nth 0 d i)) ->
  forall p, p \in forced next links marked d -> same_numbers p.1 p.2.
Proof.
move=> G Rd p /(forcedP G.1) [[j m ->]|[j lj ->]|[l ml ->]] /=.
- have [u uE mu] := markedE m.
  have : head 0 marked \in marked by case: (marked) m => // *; exact: mem_head.
  by case/markedE=> v vE mv; exists v, u; split=> //; exact: (congruence_mark Cg).
- have [u [v [uE vE s]]] := Rd j lj; exists (nextD u), (nextD v).
  by rewrite -!next_number uE vE; split=> //; exact: (congruence_next Cg).
have [k [mk E <-]] := first_endP d ml.
have [u [u' [uE uE' lu]]] : exists u u', [/\ number u = l.1, number u' = l.2 & linkedD u u'].
  by apply: linkedE; rewrite -surjective_pairing.
have [v [v' [vE vE' lv]]] : exists v v', [/\ number v = k.1, number v' = k.2 & linkedD v v'].
  by apply: linkedE; rewrite -surjective_pairing.
exists u', v'; split=> //; apply: (congruence_link Cg) lu lv; apply: same_numbersE.
apply: same_numbers_trans (Rd _ (number_small u)) _; rewrite uE -E -vE.
exact/same_numbers_sym/Rd.
Qed.

Theorem classes_same x y : (nth 0 c (number x) == nth 0 c (number y)) = same x y.
Proof.
have [G sat] := final; apply/eqP/idP=> [E|].
  have Rc i : i < n -> same_numbers i (nth 0 c i).
    apply: closure_sound => //; [exact: same_numbers_sym | exact: same_numbers_trans |
      exact: forced_same | exact: least_iota |].
    move=> j lj; rewrite nth_iota // add0n; have [u uE] := number_onto lj.
    by exists u, u; split=> //; exact: refl.
  apply: same_numbersE; apply: same_numbers_trans (Rc _ (number_small x)) _; rewrite E.
  exact/same_numbers_sym/Rc.
suff C : congruence nextD linkedD markedD (fun x y => nth 0 c (number x) == nth 0 c (number y)).
  by move/(same_least C)/eqP.
have in_forced p : p \in forced next links marked c -> nth 0 c p.1 = nth 0 c p.2 by exact: sat.
have step u : nth 0 c (number (nextD u)) = nth 0 c (nth 0 next (nth 0 c (number u))).
  rewrite -next_number; apply: (in_forced (_, _)); apply/(forcedP G.1); constructor 2.
  by exists (number u).
have to_head u : markedD u -> nth 0 c (head 0 marked) = nth 0 c (number u).
  move/marked_number=> m; apply: (in_forced (_, _)); apply/(forcedP G.1); constructor 1.
  by exists (number u).
split=> [u|u v|v u w|u v|u v u' v'|u v] //.
- by rewrite eq_sym.
- by move/eqP->.
- by move/eqP=> E; rewrite !step E.
- have end_of z z' : linkedD z z' -> nth 0 c (number z')
      = nth 0 c (first_end (heads links c) (nth 0 c (number z))).
    move/links_number=> l; apply: (in_forced (_, _)); apply/(forcedP G.1); constructor 3.
    by exists (number z, number z').
  by move/eqP=> E /end_of -> /end_of ->; rewrite E.
by move=> mu mv; rewrite -(to_head u mu) -(to_head v mv).
Qed.

Theorem settled_in_settled x : settled_in links c (number x) = settled nextD linkedD markedD x.
Proof.
apply/hasP/existsP=> [[[i j] m /= E]|[y /gluedP[x' s l]]].
  have [u [v [uE vE l]]] := linkedE m; exists v; apply/gluedP; exists u => //.
  by rewrite -classes_same -(eqP E) uE.
exists (number x', number y); first exact/links_number.
by rewrite /= classes_same; exact: sym.
Qed.
End Numbered.

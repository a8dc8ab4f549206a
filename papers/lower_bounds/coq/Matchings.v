(* ---------------------------------------------------------------------------------------------
   A graph with one perfect matching only has few edges (Hetyei).

     perfect_matching E f    f goes to and fro along edges of the graph E, and moves every vertex.
     only_matching E f       there is no other.
     graph_edges E              the edges, as sets of two vertices.
     exchanged x y           the matching with x-y and f x-f y in place of two edges of f.
     no_alternating          so no such two edges are there.
     hetyei                  at most M^2 edges, where 2M is the number of vertices.
     half_graph M            a graph that has M^2.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Matchings.
Variable V : finType.
Implicit Types (E : rel V) (f g : V -> V) (x y : V).

Definition perfect_matching E f := [/\ involutive f, forall x, f x != x & forall x, E x (f x)].
Definition only_matching E f := perfect_matching E f /\ forall g, perfect_matching E g -> g =1 f.
Definition graph_edges E : {set {set V}} := [set [set p.1; p.2] | p in [pred p : V * V | E p.1 p.2]].

Section Unique.
Variables (E : rel V) (f : V -> V).
Hypotheses (symE : symmetric E) (irrE : irreflexive E) (only : only_matching E f).

(* the matching with x-y and f x-f y in place of x-f x and y-f y *)
Definition exchanged x y z :=
  if z == x then y else if z == y then x else if z == f x then f y else if z == f y then f x else f z.

Lemma no_alternating x y : E x y -> y != f x -> ~~ E (f x) (f y).
Proof.
case: only => -[fK fN fE] one Exy nyf; apply/negP=> Eff.
have nxy : y != x by apply/eqP=> e; rewrite e irrE in Exy.
have nff : f y != f x by rewrite (inj_eq (inv_inj fK)).
have nxf : x != f y by apply: contra nyf => /eqP->; rewrite fK.
have [fx fy] := (fN x, fN y).
have c1 : exchanged x y x = y by rewrite /exchanged eqxx.
have c2 : exchanged x y y = x by rewrite /exchanged (negbTE nxy) eqxx.
have c3 : exchanged x y (f x) = f y.
  by rewrite /exchanged (negbTE fx) eq_sym (negbTE nyf) eqxx.
have c4 : exchanged x y (f y) = f x.
  by rewrite /exchanged eq_sym (negbTE nxf) (negbTE fy) (negbTE nff) eqxx.
have c5 z : z \notin [:: x; y; f x; f y] -> exchanged x y z = f z.
  by rewrite !inE !negb_or => /and4P[/negbTE a /negbTE b /negbTE c /negbTE d]; rewrite /exchanged a b c d.
have out z : z \notin [:: x; y; f x; f y] -> f z \notin [:: x; y; f x; f y].
  rewrite !inE !negb_or => /and4P[a b c d].
  by rewrite !(inj_eq (inv_inj fK)) a b !andbT; apply/andP; split;
    [apply: contra c | apply: contra d] => /eqP <-; rewrite fK.
have cases z : [\/ z = x, z = y, z = f x | z = f y] \/ z \notin [:: x; y; f x; f y].
  case: (boolP (z \in _)); last by right.
  by rewrite !inE => /or4P[] /eqP->; left; [constructor 1|constructor 2|constructor 3|constructor 4].
have P : perfect_matching E (exchanged x y).
  split=> z; case: (cases z) => [[] ->|o]; rewrite ?(c1, c2, c3, c4) ?(c5 _ o) //; try by rewrite eq_sym.
  - by rewrite c5 ?out.
  - by rewrite symE.
  - by rewrite symE.
by have := one _ P x; rewrite c1 => e; rewrite e eqxx in nyf.
Qed.

Lemma ordered_edges : #|[pred p : V * V | E p.1 p.2]| <= 2 * (#|V|./2) ^ 2.
Proof.
case: only => -[fK fN fE] _.
pose off := [set p : V * V | (p.2 != p.1) && (p.2 != f p.1)].
pose A := [set p : V * V | E p.1 p.2 && (p.2 != f p.1)].
pose turn (p : V * V) := (f p.1, f p.2).
have turnI : injective turn by move=> [x y] [x' y'] [/(inv_inj fK)-> /(inv_inj fK)->].
have cover : A :|: turn @: A \subset off.
  apply/subsetP=> p; rewrite !inE => /orP[/andP[e ->]|/imsetP[q]].
    by rewrite andbT; apply/eqP=> s; rewrite s irrE in e.
  rewrite !inE => /andP[e n] -> /=; rewrite !(inj_eq (inv_inj fK)).
  by rewrite n andbT; apply/eqP=> s; rewrite s irrE in e.
have apart : [disjoint A & turn @: A].
  rewrite disjoint_subset; apply/subsetP=> p; rewrite !inE => /andP[e n].
  apply/imsetP=> -[q]; rewrite inE => /andP[e' n'] pq; have := no_alternating e' n'.
  by rewrite pq /= in e; rewrite e.
have evenV : #|V| = (#|V|./2).*2.
  have two x : order f x = 2.
    have U : uniq [:: x; f x] by rewrite /= inE eq_sym fN.
    by rewrite (order_cycle _ U (mem_head _ _)) //= fK !eqxx.
  rewrite -{1}(@fcard_order_set _ f (inv_inj fK) 2 predT) //; last by apply/subsetP=> x _; rewrite inE two.
  by rewrite -[in RHS](@fcard_order_set _ f (inv_inj fK) 2 predT) ?muln2 ?doubleK //;
    apply/subsetP=> x _; rewrite inE two.
move: (#|V|./2) evenV => M cV.
have cA : 2 * #|A| <= #|off|.
  apply: leq_trans (subset_leq_card cover); rewrite cardsU (disjoint_setI0 apart) cards0 subn0.
  by rewrite card_imset // mul2n addnn.
have per x : #|[set y | (y != x) && (y != f x)]| = #|V| - 2.
  have -> : [set y | (y != x) && (y != f x)] = ~: [set x; f x].
    by apply/setP=> y; rewrite !inE negb_or.
  by rewrite cardsCs setCK cards2 eq_sym fN.
have coff : #|off| = #|V| * (#|V| - 2).
  rewrite -sum1_card (eq_bigl (fun p => (p.2 != p.1) && (p.2 != f p.1))); last by move=> p; rewrite inE.
  rewrite -(pair_big_dep predT (fun x y => (y != x) && (y != f x)) (fun _ _ => 1)) /=.
  rewrite (eq_bigr (fun=> #|V| - 2)) ?sum_nat_const //; move=> x _.
  by rewrite -(per x) -sum1_card; apply: eq_bigl => y; rewrite inE.
pose D := [set p : V * V | p.2 == f p.1].
have cD : #|D| = #|V|.
  have -> : D = (fun x => (x, f x)) @: V.
    by apply/setP=> -[x y]; rewrite inE /=; apply/eqP/imsetP=> [->|[z _ [-> ->] //]]; exists x.
  by rewrite card_imset // => x y [].
have total : #|[pred p : V * V | E p.1 p.2]| <= #|A| + #|D|.
  apply: leq_trans (leq_card_setU A D); apply: subset_leq_card; apply/subsetP=> p.
  by rewrite !inE => ->; case: eqP.
apply: leq_trans total _; rewrite cD; move: cA; rewrite coff cV -!mul2n => cA.
rewrite -(leq_pmul2l (m := 2)) // mulnDr; apply: leq_trans (leq_add cA (leqnn _)) _.
clear; case: M => // M; rewrite -[in 2 * M.+1 - 2](muln1 2) -mulnBr subn1 /= expnS expn1.
by apply/leP; rewrite -!(plusE, multE); lia.
Qed.

Theorem hetyei : #|graph_edges E| <= (#|V|./2) ^ 2.
Proof.
rewrite -(leq_pmul2l (m := 2)) //; apply: leq_trans ordered_edges.
have <- : \sum_(p in [pred p : V * V | E p.1 p.2]) 1 = #|[pred p : V * V | E p.1 p.2]|.
  by rewrite sum1_card.
rewrite (partition_big_imset (fun p : V * V => [set p.1; p.2])) /=.
rewrite mulnC -sum_nat_const; apply: leq_sum => e /imsetP[p Ep ->].
have Ep' : E p.1 p.2 by [].
have n : p.1 != p.2 by apply/eqP=> s; rewrite s irrE in Ep'.
rewrite sum1_card (cardD1 p) (cardD1 (p.2, p.1)) !unfold_in /= !unfold_in /= [E p.2 _]symE.
rewrite [E _ _]Ep eqxx /= [[set p.2; _]]setUC eqxx andbT -pair_eqE /= negb_and n orbT.
by [].
Qed.
End Unique.
End Matchings.

(* ---- M^2 edges: i on the left is joined to j >= i on the right, the right ones to each other ---- *)
Section Half.
Variable M : nat.
Local Notation vertex := ('I_M * bool)%type.

Definition half_graph : rel vertex := fun x y =>
  if x.2 then (if y.2 then x.1 != y.1 else y.1 <= x.1) else (y.2 && (x.1 <= y.1)).
Definition across (x : vertex) : vertex := (x.1, ~~ x.2).

Lemma half_symmetric : symmetric half_graph.
Proof. by move=> [i []] [j []]; rewrite /half_graph /= // eq_sym. Qed.

Lemma half_irreflexive : irreflexive half_graph.
Proof. by move=> [i []]; rewrite /half_graph /= ?eqxx. Qed.

Lemma half_matching : only_matching half_graph across.
Proof.
split.
  split=> [[i b]|[i b]|[i []]]; rewrite /across /half_graph ?negbK ?xpair_eqE //= ?andbF //.
  by case: b; rewrite andbF.
move=> g [gK gN gE]; have left i : g (i, false) = (i, true).
  have [k] := ubnP (M - i); elim: k i => // k IH i lk.
  have := gE (i, false); case E: (g (i, false)) => [j []]; rewrite /half_graph //= leq_eqVlt.
  case/orP=> [/eqP/val_inj->//|lij]; have ljM := ltn_ord j.
  have : M - j < k.
    rewrite ltnS in lk; apply: leq_trans lk; apply: ltn_sub2l => //; exact: ltn_trans lij ljM.
  by move/IH; rewrite -E => /(inv_inj gK)[e]; rewrite e ltnn in lij.
by move=> [i []]; [have := gK (i, false) | ]; rewrite left.
Qed.

Lemma half_graph_reaches_it : #|graph_edges half_graph| = M ^ 2.
Proof.
have cM : (#|{: vertex}|)./2 = M by rewrite card_prod card_ord card_bool muln2 doubleK.
apply/eqP; rewrite eqn_leq.
have := hetyei half_symmetric half_irreflexive half_matching; rewrite cM => -> /=.
pose edge (p : 'I_M * 'I_M) : {set vertex} :=
  if p.1 <= p.2 then [set (p.1, false); (p.2, true)] else [set (p.1, true); (p.2, true)].
have inj : injective edge.
  move=> [i j] [i' j']; rewrite /edge /=; case: (leqP i j) => l; case: (leqP i' j') => l' /setP E.
  - have := E (i, false); have := E (j, true); rewrite !inE !xpair_eqE !eqxx !andbT !andbF /= !orbF.
    by move=> /esym/eqP-> /esym/eqP->.
  - by have := E (i, false); rewrite !inE !xpair_eqE !andbF eqxx.
  - by have := E (i', false); rewrite !inE !xpair_eqE !andbF eqxx.
  have := E (i, true); have := E (j, true); rewrite !inE !xpair_eqE !eqxx !andbT /= ?orbT.
  move=> /esym e1 /esym e2; case/orP: e1 => /eqP e1; case/orP: e2 => /eqP e2; subst=> //.
  - by rewrite ltnn in l.
  - by have := ltn_trans l l'; rewrite ltnn.
  - by rewrite ltnn in l.
have <- : #|[set edge p | p in predT]| = M ^ 2 by rewrite card_imset // card_prod card_ord expnS expn1.
apply: subset_leq_card; apply/subsetP=> _ /imsetP[[i j] _ ->]; rewrite /edge /=; case: leqP => l.
  by apply/imsetP; exists ((i, false), (j, true)); rewrite // inE.
by apply/imsetP; exists ((i, true), (j, true)); rewrite // inE /half_graph /= -val_eqE /= gtn_eqF.
Qed.
End Half.

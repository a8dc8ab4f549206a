(* Lower.v -- an explorer that leaves an edge uncrossed is wrong here or in the world where that edge has a vertex of degree 2 on it;
   so a right explorer makes at least m motions. Any percepts at all. *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Rooted.
From Allworlds Require Lighthouse.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Section Subdivide.
Variables (P E : Type) (dn : E -> gmap) (X : explorer P E).
Variables (D : finType) (s a : D -> D) (r : D) (obs : D -> P) (new : bool -> P).
Hypothesis s_inj : injective s.
Hypothesis aK : involutive a.
Hypothesis aN : forall d, a d != d.
Definition world := @Gmap D (fun _ => true) s a r.
Variable e : D.
Definition s' (x : D + bool) : D + bool := match x with inl d => inl (s d) | inr c => inr (~~ c) end.
Definition a' (x : D + bool) : D + bool := match x with
  | inl d => if d == e then inr false else if d == a e then inr true else inl (a d)
  | inr c => inl (if c then a e else e) end.
Definition world' := @Gmap (D + bool)%type (fun _ => true) s' a' (inl r).
Definition obs' x := match x with inl d => obs d | inr c => new c end.
Fixpoint avoids w d := if w is k :: w' then
  let x := iter k s d in [&& x != e, x != a e & avoids w' (a x)] else true.
Lemma iter_inl k d : iter k s' (inl d) = inl (iter k s d).
Proof. by elim: k => //= k ->. Qed.
Lemma explore_sub fuel h d t est z : @explore _ _ X world obs fuel h d = (t, est, z) -> avoids (unzip1 t) d ->
  @explore _ _ X world' obs' fuel h (inl d) = (t, est, inl z).
Proof.
elim: fuel h d t => [|fl IH] h d t /=; first by case: (X h) => [k|est'] [<- <- <-].
case: (X h) => [k|est']; last by case=> <- <- <-.
case R: (explore _ _ _ _) => [[t1 e1] z1] /= [<- ee zz] /= /and3P[n1 n2 A]; subst e1 z1.
rewrite /gmv /=.
have -> : a' (iter k s' (inl d)) = inl (a (iter k s d)) by rewrite iter_inl /= (negbTE n1) (negbTE n2).
by rewrite /= (IH _ _ _ R).
Qed.
Lemma not_riso (x : D) (y : D + bool) : ~ riso (reroot world x) (reroot world' y).
Proof.
case=> f [g [F G _]]; have gi : injective g by move=> u v E'; have [_ <-] := G u isT; have [_ <-] := G v isT; rewrite E'.
have := leq_card g gi; rewrite card_sum card_bool; by rewrite leqNgt -{1}[#|D|]addn0 ltn_add2l.
Qed.
Theorem uncrossed_wrong fuel t est z : @episode _ _ X world obs fuel = (t, Some est, z) -> avoids (unzip1 t) r ->
  wf (dn est) -> riso (dn est) (reroot world z) -> ~ @right _ _ dn X world' obs'.
Proof.
move=> Ep A We Ie [f2 [t2 [e2 [z2 [E2 W2 I2]]]]].
have E1 := explore_sub Ep A; have E1' : @explore _ _ X world' obs' (f2 + fuel) [:: obs' (rt world')] (rt world') = (t, Some est, inl z).
  by rewrite addnC; exact: (@explore_more _ _ X world' obs' fuel f2 _ _ _ _ _ E1).
have E2' := @explore_more _ _ X world' obs' f2 fuel _ _ _ _ _ E2; rewrite E1' in E2'; case: E2' => _ ee zz; subst e2 z2.
exact: (not_riso (riso_trans (riso_sym We Ie) I2)).
Qed.
End Subdivide.
(* the subdivided world is a world, with a directional lighthouse too *)
Section Directional.
Import Lighthouse.
Variables (D : finType) (s a : D -> D).
Hypothesis s_inj : injective s.
Hypothesis aK : involutive a.
Hypothesis aN : forall d, a d != d.
Hypothesis conn : forall x y, connect (adj s a) x y.
Variables (e pt : D).
Local Notation S' := (@s' D s).
Local Notation A' := (@a' D a e).
Lemma s'_inj : injective S'.
Proof. by move=> [x|c] [y|d] //= [] => [/s_inj->|/negb_inj->]. Qed.
Lemma a'K : involutive A'.
Proof.
move=> [x|[]] /=; last by rewrite eqxx.
  case: (x =P e) => [->//|xe]; case: (x =P a e) => [->//|xae] /=.
  have -> : (a x == e) = false by apply/eqP=> E; apply: xae; rewrite -E aK.
  have -> : (a x == a e) = false by apply/eqP=> /(inv_inj aK).
  by rewrite aK.
by rewrite (negbTE (aN e)) eqxx.
Qed.
Lemma a'N x : A' x != x.
Proof.
apply/eqP; case: x => [x|[]] //=; case: (x =P e) => // _; case: (x =P a e) => // _ [E].
by move: (aN x); rewrite E eqxx.
Qed.
Lemma conn' x y : connect (adj S' A') x y.
Proof.
have c1 z : connect (adj S' A') z (A' z) by apply: connect1; rewrite /adj eqxx orbT.
have cs z : connect (adj S' A') z (S' z) by apply: connect1; rewrite /adj eqxx.
have I u v : connect (adj S' A') (inl u) (inl v).
  case/connectP: (conn u v) => p + ->; elim: p u => //= z p IH u /andP[Az Pz].
  apply: connect_trans (IH z Pz); case/orP: Az => /eqP->; first exact: (cs (inl u)).
  have := c1 (inl u); rewrite /=; case: eqP => [->|_] H.
    exact: connect_trans H (connect_trans (cs (inr false)) (c1 (inr true))).
  move: H; case: eqP => [->|_] // H; rewrite aK.
  exact: connect_trans H (connect_trans (cs (inr true)) (c1 (inr false))).
have J u c : connect (adj S' A') (inl u) (inr c).
  apply: connect_trans (I u (if c then a e else e)) _; have := c1 (A' (inr c)); rewrite a'K.
  by [].
case: x => [u|c]; first by case: y => [v|d]; [exact: I|exact: J].
by apply: connect_trans (c1 (inr c)) _; case: y => [v|d]; [exact: I|exact: J].
Qed.
Lemma conn_inl d y : fconnect S' (inl d) y = if y is inl d' then fconnect s d d' else false.
Proof.
apply/idP/idP=> [c|]; last by case: y => // d' c; rewrite -(iter_findex c) -iter_inl fconnect_iter.
by rewrite -(iter_findex c) iter_inl fconnect_iter.
Qed.
Lemma order_inl d : fingraph.order S' (inl d) = fingraph.order s d.
Proof.
rewrite /fingraph.order -(card_image (f := @inl D bool)); last by move=> x y [].
apply: eq_card => y; rewrite -topredE /= conn_inl; apply/idP/imageP=> [|[d' c ->]] //.
by case: y => // d' c; exists d'.
Qed.
Lemma findex_inl d p : fconnect s d p -> findex S' (inl d) (inl p) = findex s d p.
Proof.
by move=> c; rewrite -{1}(iter_findex c) -iter_inl findex_iter // order_inl findex_max.
Qed.
Lemma order_inr c : fingraph.order S' (inr c) = 2.
Proof.
rewrite /fingraph.order (@eq_card _ _ (mem [:: inr c; inr (~~ c)])).
  have U : uniq [:: inr c; inr (~~ c) : D + bool] by case: (c).
  exact: (card_uniqP U).
move=> y; transitivity ((y == inr c) || (y == inr (~~ c))); last by rewrite !inE.
rewrite -topredE /=; apply/idP/idP=> [H|/orP[]/eqP->]; last first.
- exact: (fconnect_iter S' 1).
- exact: connect0.
rewrite -(iter_findex H); elim: (findex _ _ _) => [|n IH]; first by rewrite eqxx.
by rewrite iterS; case/orP: IH => /eqP-> /=; rewrite ?negbK eqxx ?orbT.
Qed.
Lemma obs_sub x : obs S' (inl pt) x = obs' (obs s pt) (fun _ => (2, None)) x.
Proof.
case: x => [d|c]; rewrite /obs /bear /=.
  by rewrite order_inl conn_inl; case: ifP => // cd; rewrite findex_inl.
by rewrite order_inr (fconnect_sym s'_inj) conn_inl.
Qed.
End Directional.
Section LowerBound.
Variables (P E : Type) (dn : E -> gmap) (X : explorer P E).
Variables (D : finType) (s a : D -> D) (r : D) (obs : D -> P).
Hypothesis aK : involutive a.
Fixpoint crossed w d : seq D := if w is k :: w' then let x := iter k s d in [:: x, a x & crossed w' (a x)] else [::].
Lemma avoidsP e w d : avoids s a e w d = (e \notin crossed w d).
Proof.
elim: w d => //= k w IH d; rewrite IH !inE !negb_or eq_sym; congr (_ && (_ && _)).
by rewrite -(inj_eq (inv_inj aK) _ (a e)) aK eq_sym.
Qed.
(* right here, and right wherever one edge of this world carries one more vertex (whatever is sensed there): at least m motions *)
Theorem at_least_m fuel t est z : @episode _ _ X (world s a r) obs fuel = (t, Some est, z) ->
  wf (dn est) -> riso (dn est) (reroot (world s a r) z) ->
  (forall e, exists new, @right _ _ dn X (world' s a r e) (obs' obs new)) -> #|D| <= (size t).*2.
Proof.
move=> Ep We Ie H; have sz w d : size (crossed w d) = (size w).*2 by elim: w d => //= k w IH d; rewrite IH.
rewrite -(size_map fst) -(sz _ r); apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> e _.
apply/negPn/negP=> ne; have [new Rt] := H e.
by apply: (uncrossed_wrong Ep _ We Ie Rt); rewrite avoidsP.
Qed.
End LowerBound.
Lemma explore_ext P E (X : explorer P E) (M : gmap) (o1 o2 : car M -> P) : (forall x, o1 x = o2 x) ->
  forall fuel h d, @explore _ _ X M o1 fuel h d = @explore _ _ X M o2 fuel h d.
Proof. by move=> H; elim=> [|fl IH] h d /=; case: (X h) => // k; rewrite H IH. Qed.
(* every explorer that is right with a directional lighthouse, in every finite connected world, makes at least m motions in each *)
Theorem directional_at_least_m (E : Type) (dn : E -> gmap) (X : explorer (nat * option nat) E) :
  (forall (D : finType) (s a : D -> D) r pt, injective s -> involutive a -> (forall d, a d != d) ->
     (forall x y, connect (Lighthouse.adj s a) x y) -> fconnect s r pt ->
     @right _ _ dn X (world s a r) (Lighthouse.obs s pt)) ->
  forall (D : finType) (s a : D -> D) r pt, injective s -> involutive a -> (forall d, a d != d) ->
     (forall x y, connect (Lighthouse.adj s a) x y) -> fconnect s r pt ->
  exists fuel t e z, @episode _ _ X (world s a r) (Lighthouse.obs s pt) fuel = (t, Some e, z) /\ #|D| <= (size t).*2.
Proof.
move=> H D s a r pt si aK aN cn f; have [fuel [t [e [z [Ep We Ie]]]]] := H D s a r pt si aK aN cn f.
exists fuel, t, e, z; split=> //; apply: (at_least_m aK Ep We Ie) => e'; exists (fun _ => (2, None)).
have [fu [t2 [e2 [z2 [E2 W2 I2]]]]] := H _ _ _ (inl r) (inl pt) (s'_inj si) (a'K aK aN e') (a'N aN e') (conn' aK aN cn e') 
  (etrans (conn_inl s r (inl pt)) f).
exists fu, t2, e2, z2; split=> //; rewrite -E2 /episode -(obs_sub si pt).
by apply: explore_ext => x; rewrite (obs_sub si).
Qed.

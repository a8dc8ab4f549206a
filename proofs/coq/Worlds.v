(* Worlds.v -- the theorem for worlds given as sequences of numbers, so that it speaks of what is computed and extracted *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Rooted.
From Allworlds Require Import Lighthouse Algorithm Refine.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma find_iota (p : pred nat) n k : k < n -> p k -> (forall j, j < k -> ~~ p j) -> find p (iota 0 n) = k.
Proof.
move=> kn pk H; have hp : has p (iota 0 n) by apply/hasP; exists k; rewrite ?mem_iota.
apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt.
  by have := before_find 0 lt; rewrite nth_iota // add0n pk.
have := nth_find 0 hp; rewrite nth_iota ?(ltn_trans lt) // add0n; exact/negP/H.
Qed.
Section SeqWorld.
Variable M : Rooted.rmap.
Hypothesis V : Rooted.valid M.
Hypothesis C : Rooted.connected (Rooted.den M).
Let n := size (Rooted.rsg M).
Let W := Rooted.validP V.
Definition osg (i : 'I_n) : 'I_n := Ordinal (Rooted.wf_sg W (ltn_ord i) : nth 0 (Rooted.rsg M) i < n).
Definition oal (i : 'I_n) : 'I_n := Ordinal (Rooted.wf_al W (ltn_ord i) : nth 0 (Rooted.ral M) i < n).
Definition ort : 'I_n := Ordinal (Rooted.wf_rt W : Rooted.rrt M < n).
Lemma osg_inj : injective osg.
Proof. by move=> i j /(congr1 val) E; apply: val_inj; apply: (Rooted.wf_inj W) => //=; exact: ltn_ord. Qed.
Lemma oalK : involutive oal.
Proof. by move=> i; apply: val_inj; apply: (Rooted.wf_alK W); exact: ltn_ord. Qed.
Lemma oalN i : oal i != i.
Proof. by apply/eqP=> /(congr1 val); apply: (Rooted.wf_alN W); exact: ltn_ord. Qed.
Lemma oconn x y : connect (adj osg oal) x y.
Proof.
have step z u : adj osg oal z u -> connect (adj osg oal) u z.
  case/orP=> /eqP->; last by apply: connect1; rewrite /adj oalK eqxx orbT.
  have : fconnect osg (osg z) z by rewrite (fconnect_sym osg_inj) fconnect1.
  by apply: connect_sub => a c /eqP <-; apply: connect1; rewrite /adj eqxx.
have sym z u : connect (adj osg oal) z u -> connect (adj osg oal) u z.
  case/connectP=> p P ->; elim: p z P => [|a p IH] z /=; first by rewrite connect0.
  by case/andP=> /step S /IH H; exact: connect_trans H S.
suff R z : connect (adj osg oal) ort z by apply: connect_trans (sym _ _ (R x)) (R y).
have H := C (A := fun i => forall l : i < n, connect (adj osg oal) ort (Ordinal l)).
have: forall l : z < n, connect (adj osg oal) ort (Ordinal l).
  apply: H => [l|i li Hi l|i li Hi l|].
  - by rewrite (_ : Ordinal l = ort) ?connect0 //; exact: val_inj.
  - apply: connect_trans (Hi li) (connect1 _); apply/orP; left; apply/eqP; exact: val_inj.
  - apply: connect_trans (Hi li) (connect1 _); apply/orP; right; apply/eqP; exact: val_inj.
  - exact: ltn_ord.
move/(_ (ltn_ord z)); congr connect; exact: val_inj.
Qed.
Lemma val_iter k (i : 'I_n) : val (iter k osg i) = iter k (nth 0 (Rooted.rsg M)) i.
Proof. by elim: k => //= k ->. Qed.
Variable pt : 'I_n.
Hypothesis pt0 : fconnect osg ort pt.
Lemma tobs_obs (i : 'I_n) : tobs M pt i = obs osg pt i.
Proof.
have E k (j : 'I_n) : (iter k (nth 0 (Rooted.rsg M)) i == j) = (iter k osg i == j) by rewrite -val_iter.
have o0 := order_gt0 osg i; have on : order osg i <= n by rewrite -[X in _ <= X](card_ord n) max_card.
rewrite /tobs; set d := (find _ (iota 0 (size _))).+1.
have -> : d = order osg i.
  rewrite /d -(prednK o0); congr _.+1; apply: find_iota; first by rewrite prednK.
    by rewrite E prednK // iter_order //; exact: osg_inj.
  move=> j lj; rewrite E; apply/eqP=> F; have lj' : j.+1 < order osg i by rewrite -(prednK o0) ltnS.
  by have := findex_iter lj'; rewrite F findex0.
congr (_, _); rewrite /bear; have -> : has (fun k => iter k (nth 0 (Rooted.rsg M)) i == pt) (iota 0 (order osg i)) = fconnect osg i pt.
  apply/hasP/idP=> [[k _]|c]; first by rewrite E => /eqP <-; exact: fconnect_iter.
  by exists (findex osg i pt); rewrite ?mem_iota ?findex_max // E iter_findex.
case: ifP => // c; congr Some; apply: find_iota; first exact: findex_max.
  by rewrite E iter_findex.
move=> j lj; rewrite E; apply/eqP=> F; have := findex_iter (ltn_trans lj (findex_max c)).
by rewrite F => G; rewrite G ltnn in lj.
Qed.
Local Notation wd := (wm osg oal ort).
Lemma riso_val (z : 'I_n) : Rooted.riso (Rooted.reroot wd z) (Rooted.reroot (Rooted.den M) (val z)).
Proof.
exists val, (insubd ort); split=> //= x; first by move=> _; split=> //; rewrite ?valKd.
by move=> lx; split=> //; rewrite insubdK.
Qed.
Lemma reroot_connected z : Rooted.connected (Rooted.reroot wd z).
Proof.
move=> A /= A0 As Aa x _; case/connectP: (oconn z x) => p + ->.
have H : forall u, A u -> path (adj osg oal) u p -> A (last u p).
  by elim: p => //= y p IH u Au /andP[/orP[]/eqP-> {y}]; apply: IH; auto.
exact: H.
Qed.
(* Algorithm 1, as a function of percepts, in every world that can be written down *)
Theorem algorithm1_seq fuel : paper (nv osg) n./2 <= fuel -> exists t e z, [/\
  @Rooted.episode _ _ algorithm1X (Rooted.den M) (tobs M pt) fuel = (t, Some e, z),
  Rooted.same e (Rooted.at_ M z) & size t <= paper (nv osg) n./2].
Proof.
have [_] := algorithm1_explorer osg_inj oalK oalN oconn pt0; rewrite card_ord => /(_ fuel) H /H{H} [t [e [z [A Ve Ie Cb]]]].
pose R (i : nat) (j : 'I_n) := i = val j.
have T : (@Rooted.episode _ _ algorithm1X (Rooted.den M) (tobs M pt) fuel).1 = (@Rooted.episode _ _ algorithm1X wd (obs osg pt) fuel).1.
  by apply: (@Rooted.twins_episode _ _ algorithm1X (Rooted.den M) wd (tobs M pt) (obs osg pt) R); rewrite /R //= => x y ->;
    rewrite ?tobs_obs.
have rz := Rooted.explore_run algorithm1X (M := wd) (obs osg pt) fuel [:: obs osg pt ort] ort.
have rz' := Rooted.explore_run algorithm1X (M := Rooted.den M) (tobs M pt) fuel [:: tobs M pt (Rooted.rrt M)] (Rooted.rrt M).
rewrite -[Rooted.explore _ _ _ _ _]/(@Rooted.episode _ _ algorithm1X wd (obs osg pt) fuel) A /= in rz.
rewrite -[Rooted.explore _ _ _ _ _]/(@Rooted.episode _ _ algorithm1X (Rooted.den M) (tobs M pt) fuel) T A /= in rz'.
rewrite A /= in T; have zz : (@Rooted.episode _ _ algorithm1X (Rooted.den M) (tobs M pt) fuel).2 = val z.
  rewrite rz' rz; have G w (i : nat) (j : 'I_n) : i = val j -> Rooted.grun (Rooted.den M) w i = val (Rooted.grun wd w j).
    elim: w i j => //= k w IH i j ij; apply: IH; rewrite /Rooted.gmv /= ij; congr (nth _ _ _).
    by rewrite -val_iter.
  exact: G.
exists t, e, (val z); split=> //; first by rewrite [LHS]surjective_pairing T zz.
have Vz : Rooted.valid (Rooted.at_ M (val z)).
  by case/and5P: V => s1 _ s3 s4 s5; apply/and5P; split=> //; exact: ltn_ord.
have I := Rooted.riso_trans Ie (riso_val z).
apply: Rooted.same_complete => //; apply: (Rooted.riso_connected (Rooted.validP Ve) Ie).
exact: reroot_connected.
Qed.
End SeqWorld.
(* the same with hypotheses that are computed: every valid connected map, root dart, and bearing k *)
Corollary algorithm1_world M k : Rooted.valid M -> size (Rooted.order M) == size (Rooted.rsg M) ->
  let pt := iter k (nth 0 (Rooted.rsg M)) (Rooted.rrt M) in exists bound, forall fuel, bound <= fuel -> exists t e z,
  @Rooted.episode _ _ algorithm1X (Rooted.den M) (tobs M pt) fuel = (t, Some e, z) /\ Rooted.same e (Rooted.at_ M z).
Proof.
move=> V /(Rooted.connectedP V) C /=; exists (paper (nv (osg V)) (size (Rooted.rsg M))./2) => fuel le.
have [t [e [z [A B _]]]] := algorithm1_seq C (fconnect_iter (osg V) k (ort V)) le.
by exists t, e, z; split=> //; move: A; rewrite val_iter.
Qed.

(* Lighthouse.v -- Coq 8.16.1, MathComp ssreflect 1.15.0.   coqc -Q . Lighthouse Lighthouse.v *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- 1. What an explorer knows: a partial map; it never mentions a world ---- *)
Definition dart := (nat * nat)%type.                    (* vertex number, position clockwise *)
Record state := State { degs : seq nat; links : seq (dart * dart) }.
Definition deg S v := nth 0 (degs S) v.
Definition known S (e : dart) := (e.1 < size (degs S)) && (e.2 < deg S e.1).
Definition link S e := ohead [seq p.2 | p <- links S & p.1 == e].
Definition linked S e := e \in unzip1 (links S).
Definition isopen S e := known S e && ~~ linked S e.
Definition turn S k (e : dart) : dart := (e.1, (e.2 + k) %% deg S e.1).
Fixpoint srun S w e := if w is k :: w' then
  if link S (turn S k e) is Some f then srun S w' f else None else Some e.
Definition sobs b S (e : dart) :=                       (* expected percept; b = first bearing *)
  (deg S e.1, if e.1 == 0 then Some ((b + (deg S 0 - e.2)) %% deg S 0) else None).
Fixpoint strace b S w e := sobs b S e :: (if w is k :: w' then
  if link S (turn S k e) is Some f then strace b S w' f else [::] else [::]).

(* ---- 2. The world ---- *)
Section World.
Variable D : finType.
Variables sigma alpha : D -> D.
Hypothesis sigma_inj : injective sigma.
Hypothesis alphaK : involutive alpha.
Hypothesis alphaN : forall d, alpha d != d.
Definition adj : rel D := fun x y => (y == sigma x) || (y == alpha x).
Hypothesis conn : forall x y, connect adj x y.

Definition mv k d := alpha (iter k sigma d).
Fixpoint run w d := if w is k :: w' then run w' (mv k d) else d.

Lemma alpha_inj : injective alpha. Proof. exact: inv_inj. Qed.
Lemma iter_sigma_inj k : injective (iter k sigma).
Proof. by elim: k => [|k IH] x y //= /sigma_inj /IH. Qed.
Lemma mv_inj k : injective (mv k).
Proof. by move=> x y /alpha_inj /iter_sigma_inj. Qed.
(* key lemma: where a fixed word ends determines where it began *)
Lemma run_inj w : injective (run w).
Proof. by elim: w => [|k w IH] x y //= /IH /mv_inj. Qed.

(* reversal: cross back, turn by -k, ... (the last turn is free) *)
Fixpoint unwind ks d := if ks is k :: ks' then unwind ks' (iter k (finv sigma) (alpha d)) else d.
Lemma unwind_rcons s k d : unwind (rcons s k) d = iter k (finv sigma) (alpha (unwind s d)).
Proof. by elim: s d => //= a s IH d. Qed.
Lemma iter_finvK k : cancel (iter k sigma) (iter k (finv sigma)).
Proof. by elim: k => [|k IH] x //; rewrite iterSr (finv_f sigma_inj) IH. Qed.
Lemma unwindK w d : unwind (rev w) (run w d) = d.
Proof.
elim: w d => //= k w IH d; rewrite rev_cons unwind_rcons IH /mv alphaK; exact: iter_finvK.
Qed.

(* two morphisms that agree on one dart agree: so an automorphism fixing a dart is the identity *)
Lemma morph_eq (E : finType) (sE aE : E -> E) (f g : D -> E) d :
  (forall x, f (sigma x) = sE (f x)) -> (forall x, f (alpha x) = aE (f x)) ->
  (forall x, g (sigma x) = sE (g x)) -> (forall x, g (alpha x) = aE (g x)) ->
  f d = g d -> f =1 g.
Proof.
move=> fs fa gs ga fgd x; case/connectP: (conn d x) => p + ->.
elim: p d fgd => //= y p IH d fgd /andP[/orP[]/eqP-> {y}]; apply: IH.
  by rewrite fs gs fgd.
by rewrite fa ga fgd.
Qed.
Corollary aut_fix (f : D -> D) d : (forall x, f (sigma x) = sigma (f x)) ->
  (forall x, f (alpha x) = alpha (f x)) -> f d = d -> f =1 id.
Proof. by move=> fs fa fd; apply: (@morph_eq D sigma alpha f id d). Qed.

Lemma closed_full (A : D -> Prop) d : A d -> (forall x, A x -> A (sigma x)) ->
  (forall x, A x -> A (alpha x)) -> forall x, A x.
Proof.
move=> Ad As Aa x; case/connectP: (conn d x) => p + ->.
by elim: p d Ad => //= y p IH d Ad /andP[/orP[]/eqP-> {y}]; apply: IH; auto.
Qed.

Lemma order_conn x y : fconnect sigma x y -> order sigma y = order sigma x.
Proof.
move=> c; rewrite /order; apply: eq_card => z.
by rewrite -!topredE /= (same_connect (fconnect_sym sigma_inj) c).
Qed.
Lemma iter_mod n x : iter (n %% order sigma x) sigma x = iter n sigma x.
Proof.
rewrite [in RHS](divn_eq n (order sigma x)) addnC iterD; congr (iter _ _ _).
by elim: (n %/ _) => //= k IH; rewrite mulSn iterD -IH iter_order.
Qed.

(* ---- 3. Percepts: degree, and bearing of the pointed dart when at the marked vertex ---- *)
Variables d0 pt : D.
Hypothesis pt0 : fconnect sigma d0 pt.
Definition bear d := if fconnect sigma d pt then Some (findex sigma d pt) else None.
Definition obs d := (order sigma d, bear d).
Fixpoint trace w d := obs d :: (if w is k :: w' then trace w' (mv k d) else [::]).
Definition b := findex sigma d0 pt.

Lemma trace_last w d x : last x (trace w d) = obs (run w d).
Proof. by elim: w d x => //= k w IH d x; rewrite IH. Qed.

Lemma bear_inj x y j : bear x = Some j -> bear y = Some j -> x = y.
Proof.
rewrite /bear; case: ifP => // cx [jx]; case: ifP => // cy [jy].
by apply: (@iter_sigma_inj j); rewrite -{1}jx -jy !iter_findex.
Qed.

(* ---- 4. The invariant (I-1, I-2): S is embedded in the world by phi ---- *)
Definition phi (r : seq D) (e : dart) := iter e.2 sigma (nth d0 r e.1).
Record inv S (r : seq D) : Prop := Inv {
  inv_deg : degs S = [seq order sigma x | x <- r];
  inv_0 : 0 < size r /\ nth d0 r 0 = d0;
  inv_sep : forall v w, v < size r -> w < size r ->
    fconnect sigma (nth d0 r v) (nth d0 r w) -> v = w;
  inv_link : forall e f, (e, f) \in links S ->
    [/\ known S e, known S f, alpha (phi r e) = phi r f & (f, e) \in links S];
  inv_uniq : uniq (unzip1 (links S)) }.

Section Inv.
Variables (S : state) (r : seq D).
Hypothesis I : inv S r.

Lemma size_r : size (degs S) = size r.
Proof. by rewrite (inv_deg I) size_map. Qed.
Lemma deg_r v : v < size r -> deg S v = order sigma (nth d0 r v).
Proof. by move=> lt; rewrite /deg (inv_deg I) (nth_map d0). Qed.
Lemma knownP e : known S e -> e.1 < size r /\ e.2 < order sigma (nth d0 r e.1).
Proof. by case/andP; rewrite size_r => l1 l2; rewrite -deg_r. Qed.
Lemma phi_conn e : fconnect sigma (nth d0 r e.1) (phi r e).
Proof. exact: fconnect_iter. Qed.
Lemma phi_inj e f : known S e -> known S f -> phi r e = phi r f -> e = f.
Proof.
move=> /knownP[l1 l2] /knownP[k1 k2] E.
have v1 : e.1 = f.1.
  apply: (inv_sep I) => //; apply: connect_trans (phi_conn e) _.
  by rewrite E (fconnect_sym sigma_inj); exact: phi_conn.
have v2 : e.2 = f.2.
  by rewrite -(findex_iter l2) -[iter _ _ _]/(phi r e) E /phi v1 findex_iter.
by rewrite (surjective_pairing e) v1 v2 -surjective_pairing.
Qed.
Lemma known_turn k e : known S e -> known S (turn S k e).
Proof. by case/andP=> l1 l2; rewrite /known l1 ltn_mod (leq_ltn_trans _ l2). Qed.
Lemma phi_turn k e : known S e -> phi r (turn S k e) = iter k sigma (phi r e).
Proof.
move=> /knownP[l1 _]; rewrite /phi /turn /= deg_r // iter_mod.
by rewrite addnC iterD.
Qed.
Lemma linkP e f : link S e = Some f -> (e, f) \in links S.
Proof.
rewrite /link; case E: [seq _ | _ <- _ & _] => [|x s] //= [<-].
have: x \in x :: s by rewrite inE eqxx.
rewrite -E => /mapP[[a c]]; rewrite mem_filter => /andP[/eqP /= <- m] -> //.
Qed.
Lemma srun_phi w e f : known S e -> srun S w e = Some f ->
  known S f /\ run w (phi r e) = phi r f.
Proof.
elim: w e => [|k w IH] e ke /=; first by case=> <-.
case L: (link S (turn S k e)) => [g|] // R.
have [_ kg ag _] := inv_link I (linkP L).
by rewrite /mv -phi_turn // ag; exact: IH.
Qed.

Lemma sobs_phi e : known S e -> sobs b S e = obs (phi r e).
Proof.
move=> ke; have [l1 l2] := knownP ke; rewrite /sobs /obs deg_r //.
rewrite (order_conn (phi_conn e)); congr (_, _).
have [r0 n0] := inv_0 I; case: eqP => [e0|ne0]; last first.
  rewrite /bear; case: ifP => // c; case: ne0; apply: (inv_sep I) => //; rewrite n0.
  apply: connect_trans (phi_conn e) _; apply: connect_trans c _.
  by rewrite (fconnect_sym sigma_inj).
rewrite deg_r // n0; rewrite e0 n0 in l2; rewrite /phi e0 n0.
set i := e.2 in l2 *; set o := order sigma d0 in l2 *.
have c : fconnect sigma d0 (iter i sigma d0) by exact: fconnect_iter.
have oi : order sigma (iter i sigma d0) = o by rewrite (order_conn c).
have E : iter ((b + (o - i)) %% o) sigma (iter i sigma d0) = pt.
  rewrite -{2}oi iter_mod -iterD -addnA subnK ?(ltnW l2) // iterD iter_order //.
  exact: iter_findex.
rewrite /bear; have -> : fconnect sigma (iter i sigma d0) pt by rewrite -E; exact: fconnect_iter.
congr Some; by rewrite -[X in findex _ _ X]E findex_iter // oi ltn_mod (leq_ltn_trans _ l2).
Qed.
Lemma strace_phi w e f : known S e -> srun S w e = Some f ->
  strace b S w e = trace w (phi r e).
Proof.
elim: w e => [|k w IH] e ke /=; first by rewrite sobs_phi.
case L: (link S (turn S k e)) => [g|] // R; rewrite sobs_phi //.
have [_ kg ag _] := inv_link I (linkP L).
by rewrite (IH g) // /mv -phi_turn // ag.
Qed.

(* the verdict lemma: a test that matches to the end proves its hypothesis, a true one matches *)
Lemma verdict w h f x : known S h -> srun S w h = Some f -> f.1 = 0 ->
  trace w x = strace b S w h -> x = phi r h.
Proof.
move=> kh R f0 T; have [kf E] := srun_phi kh R.
have: last (obs x) (trace w x) = last (obs x) (trace w (phi r h)) by rewrite T (strace_phi kh R).
rewrite !trace_last E -(sobs_phi kf) /sobs f0 /= /obs => -[_ B].
apply: (@run_inj w); rewrite E; apply: (bear_inj B).
by have := sobs_phi kf; rewrite /sobs /obs f0 /= => -[_ <-].
Qed.
Lemma complete w h f : known S h -> srun S w h = Some f ->
  trace w (phi r h) = strace b S w h.
Proof. by move=> kh R; rewrite (strace_phi kh R). Qed.

Lemma linkedP e : linked S e -> exists f, (e, f) \in links S.
Proof. by case/mapP=> -[a c] m /= ->; exists c. Qed.
Lemma link_total e : linked S e -> exists f, link S e = Some f.
Proof.
case/linkedP=> f m; rewrite /link; case E: [seq _ | _ <- _ & _] => [|y s]; last by exists y.
by have: f \in [seq p.2 | p <- links S & p.1 == e];
  [apply/mapP; exists (e, f); rewrite // mem_filter eqxx | rewrite E].
Qed.
(* where the other end of an open dart can be: a different open dart, or nowhere in S (I-2) *)
Lemma other_end e f : isopen S e -> known S f -> alpha (phi r e) = phi r f ->
  isopen S f /\ f != e.
Proof.
move=> /andP[ke oe] kf E; split; last first.
  by apply/eqP=> fe; move: (alphaN (phi r e)); rewrite E fe eqxx.
rewrite /isopen kf; apply/negP=> /linkedP[g m]; have [_ kg ag mg] := inv_link I m.
have ge : g = e by apply: phi_inj => //; rewrite -ag -E alphaK.
by case/negP: oe; rewrite -ge; apply/mapP; exists (g, f).
Qed.

(* I-1 is kept by both augmentations *)
Definition add_loop e h := State (degs S) [:: (e, h), (h, e) & links S].
Lemma inv_loop e h : isopen S e -> isopen S h -> h != e -> alpha (phi r e) = phi r h ->
  inv (add_loop e h) r.
Proof.
move=> /andP[ke oe] /andP[kh oh] he E; split; try by case: I.
- move=> x y; rewrite !inE => /or3P[/eqP[-> ->]|/eqP[-> ->]|m].
  + by rewrite eqxx orbT.
  + by rewrite eqxx -E alphaK; split.
  + by have [a1 a2 a3 a4] := inv_link I m; split; rewrite // a4 !orbT.
- by rewrite /= inE negb_or eq_sym he oe oh (inv_uniq I).
Qed.
Definition fresh : dart := (size (degs S), 0).
Definition add_vertex e k := State (rcons (degs S) k) [:: (e, fresh), (fresh, e) & links S].
Lemma known_rcons k l f : known S f -> known (State (rcons (degs S) k) l) f.
Proof.
by case/andP=> l1 l2; rewrite /known /deg /= size_rcons nth_rcons l1 (ltnW (n:=_.+1)) //=.
Qed.
Lemma phi_rcons x f : known S f -> phi (rcons r x) f = phi r f.
Proof. by case/knownP=> l1 _; rewrite /phi nth_rcons l1. Qed.
Lemma phi_fresh x : phi (rcons r x) fresh = x.
Proof. by rewrite /phi /fresh /= size_r nth_rcons ltnn eqxx. Qed.
Lemma known_fresh x l : known (State (rcons (degs S) (order sigma x)) l) fresh.
Proof. by rewrite /known /deg /= size_rcons nth_rcons ltnn eqxx ltnSn order_gt0. Qed.
Lemma fresh_unknown : ~~ known S fresh.
Proof. by rewrite /known /= ltnn. Qed.
Lemma outside x v : (forall f, known S f -> phi r f <> x) -> v < size r ->
  ~~ fconnect sigma (nth d0 r v) x.
Proof.
move=> out lv; apply/negP=> c; apply: (out (v, findex sigma (nth d0 r v) x)).
  by rewrite /known /= size_r lv deg_r //= findex_max.
by rewrite /phi /= iter_findex.
Qed.
Lemma inv_vertex e : isopen S e -> let x := alpha (phi r e) in
  (forall f, known S f -> phi r f <> x) -> inv (add_vertex e (order sigma x)) (rcons r x).
Proof.
move=> /andP[ke oe] x out.
have kf : known (add_vertex e (order sigma x)) fresh by exact: known_fresh.
have kr f : known S f -> known (add_vertex e (order sigma x)) f by exact: known_rcons.
split.
- by rewrite /= (inv_deg I) map_rcons.
- by have [p q] := inv_0 I; rewrite size_rcons nth_rcons p.
- move=> v w; rewrite size_rcons !ltnS !nth_rcons.
  rewrite leq_eqVlt => /orP[/eqP->|lv]; rewrite leq_eqVlt => /orP[/eqP->|lw]; rewrite ?ltnn ?eqxx //.
  + by rewrite lw (fconnect_sym sigma_inj) => c; case/negP: (outside out lw).
  + by rewrite lv => c; case/negP: (outside out lv).
  + by rewrite lv lw; exact: (inv_sep I).
- move=> y z; rewrite !inE => /or3P[/eqP[-> ->]|/eqP[-> ->]|m].
  + by rewrite kf kr // (phi_rcons x ke) (phi_fresh x) eqxx orbT.
  + by rewrite kf kr // (phi_rcons x ke) (phi_fresh x) /x alphaK eqxx.
  + have [a1 a2 a3 a4] := inv_link I m.
    by rewrite !kr // !phi_rcons // a4 !orbT.
- have lf : fresh \notin unzip1 (links S).
    apply/negP=> /linkedP[g m]; have [k1 _ _ _] := inv_link I m.
    by move: fresh_unknown; rewrite k1.
  rewrite /= inE negb_or oe lf (inv_uniq I) andbT /=.
  by rewrite andbT; apply/eqP=> ef; move: fresh_unknown; rewrite -ef ke.
Qed.
Lemma size_links : size (links S) <= #|D|.
Proof.
rewrite -(size_map fst) -(size_map (phi r)) -(card_uniqP _) ?max_card //.
rewrite map_inj_in_uniq ?(inv_uniq I) // => e f /linkedP[g m] /linkedP[g' m'].
have [k1 _ _ _] := inv_link I m; have [k2 _ _ _] := inv_link I m'; exact: phi_inj.
Qed.
(* exit: no open dart => phi is an isomorphism of rooted maps *)
Definition iso := [/\ forall d, exists2 e, known S e & phi r e = d,
  forall e f, known S e -> known S f -> phi r e = phi r f -> e = f,
  forall e, known S e -> phi r (turn S 1 e) = sigma (phi r e),
  forall e, known S e -> exists f, [/\ link S e = Some f, known S f & phi r f = alpha (phi r e)]
  & phi r (0, 0) = d0].
Lemma exit_iso : (forall e, ~~ isopen S e) -> iso.
Proof.
have [r0 n0] := inv_0 I; move=> nopen.
have L e : known S e -> exists f, [/\ link S e = Some f, known S f & phi r f = alpha (phi r e)].
  move=> ke; move: (nopen e); rewrite /isopen ke /= negbK => /link_total[f lf].
  by exists f; have [_ kf a _] := inv_link I (linkP lf).
have k0 : known S (0, 0) by rewrite /known /= size_r r0 deg_r // order_gt0.
split=> //; [|exact: phi_inj|by move=> e ke; rewrite phi_turn].
apply: (@closed_full (fun d => exists2 e, known S e & phi r e = d) d0).
- by exists (0, 0).
- by move=> _ [e ke <-]; exists (turn S 1 e); [exact: known_turn | rewrite phi_turn].
- by move=> _ [e ke <-]; have [f [_ kf pf]] := L _ ke; exists f.
Qed.
End Inv.

(* ---- 5. Paths inside S: from every known dart to v0 and back (the spanning tree) ---- *)
Definition rch S a v := exists w f, srun S w a = Some f /\ f.1 = v.
Lemma srun_cat S w w' a f : srun S w a = Some f -> srun S (w ++ w') a = srun S w' f.
Proof.
by elim: w a => [|k w IH] a /=; [case=> -> | case: (link S _) => [g|] //; exact: IH].
Qed.
Lemma rch_trans S w a f v : srun S w a = Some f -> rch S f v -> rch S a v.
Proof. by move=> R [w' [g [R' E]]]; exists (w ++ w'), g; rewrite (srun_cat _ R). Qed.
Lemma turn_to S a e : known S a -> known S e -> a.1 = e.1 ->
  turn S (deg S a.1 - a.2 + e.2) a = e.
Proof.
case/andP=> _ l2 /andP[_ k2] E; rewrite /turn addnA subnKC ?(ltnW l2) //.
by rewrite modnDl E modn_small // -surjective_pairing.
Qed.
Lemma rch_anchor S a a' v : rch S a v -> known S a' -> a'.1 = a.1 -> rch S a' v.
Proof.
case=> -[|k w] [f [R E]] /andP[_ l2] E1; first by exists [::], a'; rewrite E1 -E; case: R => ->.
exists (deg S a.1 - a'.2 + (a.2 + k) :: w), f; split=> //; rewrite -R /=.
suff -> : turn S (deg S a.1 - a'.2 + (a.2 + k)) a' = turn S k a by [].
by rewrite /turn -E1 addnA subnKC ?(ltnW l2) // modnDl.
Qed.
Definition reach S := forall e, known S e -> rch S e 0 /\ rch S (0, 0) e.1.

Lemma srun_mono S S' r w e f : inv S r -> (forall x, known S x -> deg S' x.1 = deg S x.1) ->
  (forall x y, link S x = Some y -> link S' x = Some y) ->
  known S e -> srun S w e = Some f -> srun S' w e = Some f.
Proof.
move=> I dg lk; elim: w e => [|k w IH] e ke //=.
have -> : turn S' k e = turn S k e by rewrite /turn dg.
case L: (link S _) => [g|] //; rewrite (lk _ _ L).
by have [_ kg _ _] := inv_link I (linkP L); exact: IH.
Qed.
Lemma rch_mono S S' r e v : inv S r -> (forall x, known S x -> deg S' x.1 = deg S x.1) ->
  (forall x y, link S x = Some y -> link S' x = Some y) ->
  known S e -> rch S e v -> rch S' e v.
Proof. by move=> I dg lk ke [w [f [R E]]]; exists w, f; rewrite (srun_mono I dg lk ke R). Qed.
Lemma link_mono S d l e h x y : isopen S e -> ~~ linked S h ->
  link S x = Some y -> l = [:: (e, h), (h, e) & links S] -> link (State d l) x = Some y.
Proof.
move=> /andP[_ oe] oh L ->; have lx : linked S x by apply/mapP; exists (x, y); rewrite ?linkP.
rewrite /link /=; case: eqP => [ex|_]; first by rewrite ex lx in oe.
by case: eqP => [hx|_ //]; rewrite hx lx in oh.
Qed.
Lemma known00 S r : inv S r -> known S (0, 0).
Proof. by move=> I; have [r0 _] := inv_0 I; rewrite /known /= (size_r I) r0 (deg_r I) // order_gt0. Qed.
Lemma reach_loop S r e h : inv S r -> isopen S e -> isopen S h -> reach S -> reach (add_loop S e h).
Proof.
move=> I oe /andP[_ oh] Rc x kx; have [A B] := Rc x kx; have k0 := known00 I.
by split; apply: (rch_mono I) => // y z L; exact: (@link_mono S _ _ e h).
Qed.
Lemma fresh_unlinked S r : inv S r -> ~~ linked S (fresh S).
Proof.
move=> I; apply/negP=> /linkedP[g m]; have [k1 _ _ _] := inv_link I m.
by move: (fresh_unknown S); rewrite k1.
Qed.
Lemma reach_vertex S r e k : inv S r -> isopen S e -> 0 < k -> reach S -> reach (add_vertex S e k).
Proof.
move=> I oe k0 Rc; have [ke _] := andP oe; have z0 := known00 I; set S' := add_vertex S e k.
have dg x : known S x -> deg S' x.1 = deg S x.1.
  by case/andP=> l1 _; rewrite /deg /= nth_rcons l1.
have lk x y : link S x = Some y -> link S' x = Some y.
  by move=> L; apply: (@link_mono S _ _ e (fresh S)) => //; exact: (fresh_unlinked I).
have kr x : known S x -> known S' x by exact: known_rcons.
have dn : deg S' (size (degs S)) = k by rewrite /deg /= nth_rcons ltnn eqxx.
have le : link S' e = Some (fresh S) by rewrite /link /= eqxx.
have ef : e != fresh S by apply/eqP=> E; move: (fresh_unknown S); rewrite -E ke.
have lf : link S' (fresh S) = Some e by rewrite /link /= (negbTE ef) eqxx.
have kf : known S' (fresh S) by rewrite /known /= size_rcons ltnSn dn.
have Rf : srun S' [:: 0] (fresh S) = Some e.
  by rewrite /= (_ : turn _ _ _ = fresh S) ?lf // /turn /fresh /= dn mod0n.
have Re : srun S' [:: 0] e = Some (fresh S).
  rewrite /= (_ : turn _ _ _ = e) ?le // /turn addn0 dg // modn_small -?surjective_pairing //.
  by case/andP: ke.
move=> x; case/andP; rewrite size_rcons ltnS leq_eqVlt => /orP[/eqP x1|lx] l2.
  have kx : known S' x by rewrite /known /= size_rcons x1 ltnSn -x1.
  split.
    apply: (@rch_anchor _ (fresh S)) => //; apply: (rch_trans Rf).
    by apply: (rch_mono I) => //; case: (Rc e ke).
  have [_ [w [f [R E]]]] := Rc e ke; have [kff _] := srun_phi I z0 R.
  apply: (rch_trans (srun_mono I dg lk z0 R)).
  apply: (@rch_anchor _ e) => //; last exact: kr.
  by exists [:: 0], (fresh S); rewrite Re x1.
have kx : known S x.
  by move: l2; rewrite /known lx /deg /= nth_rcons lx.
by have [A B] := Rc x kx; split; apply: (rch_mono I).
Qed.

(* shortest paths: inside S every dart reaches v0 in fewer steps than S has vertices *)
Definition vadj S : rel nat := fun u v => has (fun q => (q.1.1 == u) && (q.2.1 == v)) (links S).
Lemma word_path S r w a f : inv S r -> known S a -> srun S w a = Some f ->
  exists2 p, path (vadj S) a.1 p & last a.1 p = f.1.
Proof.
move=> I; elim: w a => [|k w IH] a ka /=; first by case=> ->; exists [::].
case L: (link S _) => [g|] //; have m := linkP L; have [_ kg _ _] := inv_link I m.
case/(IH g kg) => p P E; exists (g.1 :: p) => //=; rewrite P andbT.
by apply/hasP; exists (turn S k a, g); rewrite //= !eqxx.
Qed.
Lemma path_word S r p a : inv S r -> known S a -> path (vadj S) a.1 p ->
  exists w f, [/\ srun S w a = Some f, f.1 = last a.1 p & size w = size p].
Proof.
move=> I; elim: p a => [|v p IH] a ka /=; first by move=> _; exists [::], a.
case/andP=> /hasP[[[u i] [v' j]] m /= /andP[/eqP eu /eqP ev]] P; subst u v'.
have [ku kv E _] := inv_link I m; have [w [f [R l sz]]] := IH (v, j) kv P.
exists (deg S a.1 - a.2 + i :: w), f; split=> //=; last by rewrite sz.
rewrite (turn_to ka ku) //=; have lk : linked S (a.1, i) by apply/mapP; exists ((a.1, i), (v, j)).
have [g Lg] := link_total lk; rewrite Lg; have [_ kg Eg _] := inv_link I (linkP Lg).
by rewrite (phi_inj I kg kv) // -Eg -E.
Qed.
Lemma shorten S r a v : inv S r -> known S a -> rch S a v ->
  exists w f, [/\ srun S w a = Some f, f.1 = v & size w < size (degs S)].
Proof.
move=> I ka [w [f [R <-]]]; have [p0 P0 <-] := word_path I ka R.
case/shortenP: P0 => p P U _; have [w' [f' [R' E' sz]]] := path_word I ka P.
exists w', f'; split=> //; rewrite sz -[_.+1]/(size (a.1 :: p)) -(size_iota 0 (size (degs S))).
apply: uniq_leq_size => // x; rewrite inE mem_iota add0n leq0n /= => /orP[/eqP->|].
  by case/andP: ka.
move=> xp; have: all (fun y => y < size (degs S)) p.
  elim: (p) a.1 P => //= y q IH z /andP[/hasP[[e g] m /= /andP[_ /eqP<-]] Q].
  by have [_ /andP[-> _] _ _] := inv_link I m; exact: (IH _ Q).
by move/allP/(_ x xp).
Qed.

(* ---- 6. Algorithm 1 as a relation: every dart, every order, every path is allowed ---- *)
Record config := Conf { cS : state; here : dart; pos : D }.
Definition walked S x (t : dart * seq nat) :=           (* steps until the first mismatch *)
  find (fun q => q.1 != q.2) (zip (trace t.2 x) (strace b S t.2 t.1)).
Definition rejected S e x (ts : seq (dart * seq nat)) := forall h w, (h, w) \in ts ->
  [/\ isopen S h, h != e, exists2 f, srun S w h = Some f & f.1 = 0,
      size w < size (degs S) & trace w x <> strace b S w h].
Definition test_cost S x ts := \sum_(t <- ts) 2 * walked S x t.     (* there and back *)
Inductive pass (e : dart) : config -> nat -> config -> Prop :=
| PassLoop S c p w0 g k h w f ts : isopen S e -> srun S w0 c = Some g -> turn S k g = e ->
    size w0 < size (degs S) ->
    rejected S e (mv k (run w0 p)) ts -> uniq (h :: unzip1 ts) ->
    isopen S h -> h != e -> srun S w h = Some f -> f.1 = 0 -> size w < size (degs S) ->
    trace w (mv k (run w0 p)) = strace b S w h ->
    pass e (Conf S c p) (size w0 + 1 + test_cost S (mv k (run w0 p)) ts + size w)
      (Conf (add_loop S e h) f (run w (mv k (run w0 p))))
| PassVertex S c p w0 g k ts : isopen S e -> srun S w0 c = Some g -> turn S k g = e ->
    size w0 < size (degs S) ->
    rejected S e (mv k (run w0 p)) ts -> uniq (unzip1 ts) ->
    (forall h, isopen S h -> h != e -> h \in unzip1 ts) ->
    pass e (Conf S c p) (size w0 + 1 + test_cost S (mv k (run w0 p)) ts)
      (Conf (add_vertex S e (obs (mv k (run w0 p))).1) (fresh S) (mv k (run w0 p))).
Definition start := Conf (State [:: (obs d0).1] [::]) (0, 0) d0.
Inductive runs : nat -> nat -> config -> Prop :=         (* passes, total cost *)
| Runs0 : runs 0 0 start
| RunsS n C e c C1 c' : runs n C c -> pass e c C1 c' -> runs n.+1 (C + C1) c'.

Definition ok c := exists r, [/\ inv (cS c) r, known (cS c) (here c),
  pos c = phi r (here c) & reach (cS c)].
Lemma ok_start : ok start.
Proof.
exists [:: d0]; have I : inv (cS start) [:: d0].
  by split=> //; move=> [|v] [|w].
split=> //; first exact: (known00 I).
move=> [[|v] i] /andP[] //= _ l2; split; first by exists [::], (0, i).
by exists [::], (0, 0).
Qed.
Lemma arrive S r c p w0 g k e : inv S r -> known S c -> p = phi r c ->
  srun S w0 c = Some g -> turn S k g = e -> mv k (run w0 p) = alpha (phi r e).
Proof.
by move=> I kc -> R <-; have [kg ->] := srun_phi I kc R; rewrite /mv (phi_turn I).
Qed.

Lemma pass_ok e c C c' : ok c -> pass e c C c' -> ok c'.
Proof.
move=> Ok P; case: P Ok => S d p w0 g k.
  move=> h w f ts oe R T _ _ _ oh he Rh f0 _ V [r [/= I kd pd Rc]].
  rewrite (arrive I kd pd R T) in V *; have [kh _] := andP oh.
  have X := verdict I kh Rh f0 V; have [kf E] := srun_phi I kh Rh.
  exists r; split=> /=; first exact: inv_loop.
  - by [].
  - by rewrite X.
  - exact: (reach_loop I).
move=> ts oe R T _ Rj _ H [r [/= I kd pd Rc]]; rewrite (arrive I kd pd R T) in Rj H *.
have [ke _] := andP oe; set x := alpha _ in Rj H *.
have out f : known S f -> phi r f <> x.
  move=> kf E; have [opf fe] := other_end I oe kf (esym E).
  case/mapP: (H f opf fe) => -[h w] m /= fh; subst h; have [_ _ [g' Rw g0] _ NV] := Rj f w m.
  by apply: NV; rewrite -E; exact: (complete I kf Rw).
exists (rcons r x); split=> /=; first exact: inv_vertex.
- exact: known_fresh.
- by rewrite (phi_fresh I).
- by apply: (reach_vertex I) => //; exact: order_gt0.
Qed.
Definition opens S := [seq h <- undup (flatten [seq [seq (v, i) | i <- iota 0 (deg S v)]
  | v <- iota 0 (size (degs S))]) | isopen S h].
Lemma mem_opens S h : (h \in opens S) = isopen S h.
Proof.
rewrite mem_filter mem_undup andb_idr // => /andP[/andP[l1 l2] _].
apply/flatten_mapP; exists h.1; first by rewrite mem_iota.
by apply/mapP; exists h.2; rewrite ?mem_iota // -surjective_pairing.
Qed.
Lemma list_choice (T U : eqType) (P : T -> U -> Prop) (s : seq T) :
  (forall x, x \in s -> exists y, P x y) ->
  exists ts : seq (T * U), unzip1 ts = s /\ forall x y, (x, y) \in ts -> P x y.
Proof.
elim: s => [|x s IH] H; first by exists [::].
have [y Py] := H x (mem_head _ _).
have [|ts [E Q]] := IH; first by move=> z zs; apply: H; rewrite inE zs orbT.
exists ((x, y) :: ts); split=> [|a c]; first by rewrite /= E.
by rewrite inE => /orP[/eqP[-> ->]|]; [exact: Py | exact: Q].
Qed.
Lemma progress e c : ok c -> isopen (cS c) e -> exists C c', pass e c C c'.
Proof.
case: c => S d p [r [/= I kd pd Rc]] oe; have [ke _] := andP oe.
have [w0 [g [R g1 sw0]]] : exists w0 g, [/\ srun S w0 d = Some g, g.1 = e.1 & size w0 < size (degs S)].
  apply: (shorten I kd); have [[w [f [Rw f0]]] _] := Rc d kd; have [_ A] := Rc e ke.
  by have [kf _] := srun_phi I kd Rw; exact: (rch_trans Rw (rch_anchor A kf f0)).
have [kg _] := srun_phi I kd R; have T := turn_to kg ke g1; set k := (_ + _) in T.
have X := arrive I kd pd R T.
have path0 h : known S h -> exists w f, [/\ srun S w h = Some f, f.1 = 0 & size w < size (degs S)].
  by move=> kh; apply: (shorten I kh); case: (Rc h kh).
case: (boolP (has (fun v => fconnect sigma (nth d0 r v) (alpha (phi r e))) (iota 0 (size r)))).
  case/hasP=> v; rewrite mem_iota /= => lv c.
  pose h := (v, findex sigma (nth d0 r v) (alpha (phi r e))).
  have kh : known S h by rewrite /known /= (size_r I) lv (deg_r I) //= findex_max.
  have E : phi r h = alpha (phi r e) by rewrite /phi /= iter_findex.
  have [oh he] := other_end I oe kh (esym E); have [w [f [Rw f0 sw]]] := path0 h kh.
  do 2 eexists; apply: (@PassLoop e S d p w0 g k h w f [::] oe R T) => //.
  by rewrite X -E; exact: (complete I kh Rw).
move/hasPn=> N.
have [h|ts [tsE tsP]] := @list_choice _ _ (fun h w => [/\ isopen S h, h != e,
    exists2 f, srun S w h = Some f & f.1 = 0, size w < size (degs S) &
    trace w (alpha (phi r e)) <> strace b S w h]) [seq h <- opens S | h != e].
  rewrite mem_filter mem_opens => /andP[he oh]; have [kh _] := andP oh.
  have [w [f [Rw f0 sw]]] := path0 h kh; exists w; split=> //; first by exists f.
  move=> V; have E := verdict I kh Rw f0 V; have [lh _] := knownP I kh.
  by move: (N h.1); rewrite mem_iota lh E => /(_ isT); rewrite (phi_conn r h).
do 2 eexists; apply: (@PassVertex e S d p w0 g k ts oe R T) => //.
- by rewrite X.
- by rewrite tsE !filter_uniq ?undup_uniq.
- by move=> h oh he; rewrite tsE mem_filter he mem_opens.
Qed.
Lemma pass_links e c C c' : pass e c C c' -> size (links (cS c')) = (size (links (cS c))).+2.
Proof. by case. Qed.
Lemma pass_size e c C c' : pass e c C c' -> size (degs (cS c')) <= (size (degs (cS c))).+1.
Proof. by case=> * //=; rewrite size_rcons. Qed.

(* ---- 7. Cost ---- *)
Lemma size_strace S w h f : srun S w h = Some f -> size (strace b S w h) = (size w).+1.
Proof.
by elim: w h => //= k w IH h; case: (link S _) => //= g /IH ->.
Qed.
Lemma size_trace w x : size (trace w x) = (size w).+1.
Proof. by elim: w x => //= k w IH x; rewrite IH. Qed.
Lemma zip_neq (T : eqType) (s t : seq T) : size s = size t -> s <> t -> has (fun q => q.1 != q.2) (zip s t).
Proof.
elim: s t => [|x s IH] [|y t] //= [sz] ne; case: eqP => //= xy.
by apply: IH => // st; apply: ne; rewrite xy st.
Qed.
Lemma walked_le S e x ts h w : rejected S e x ts -> (h, w) \in ts -> walked S x (h, w) <= (size (degs S)).-1.
Proof.
move=> Rj m; have [_ _ [f Rw _] sw ne] := Rj h w m; rewrite -ltnS.
have sz : size (trace w x) = size (strace b S w h) by rewrite size_trace (size_strace Rw).
have := zip_neq sz ne; rewrite has_find size_zip -sz minnn size_trace => lt.
by rewrite prednK ?(leq_ltn_trans _ sw) //; apply: leq_trans lt _.
Qed.
Lemma test_cost_le S e x ts : rejected S e x ts ->
  test_cost S x ts <= 2 * (size (degs S)).-1 * size ts.
Proof.
move=> Rj; rewrite /test_cost; apply: (@leq_trans (\sum_(t <- ts) 2 * (size (degs S)).-1)).
  rewrite !big_seq; apply: leq_sum => -[h w] m; rewrite leq_mul2l /=.
  exact: (walked_le Rj m).
by rewrite big_const_seq count_predT iter_addn_0.
Qed.
Lemma many_open S r hs : inv S r -> uniq hs -> (forall h, h \in hs -> isopen S h) ->
  size hs + size (links S) <= #|D|.
Proof.
move=> I U O; rewrite -(size_map fst (links S)) -size_cat -(size_map (phi r)).
have kn e : e \in hs ++ unzip1 (links S) -> known S e.
  rewrite mem_cat => /orP[/O/andP[]//|/linkedP[g m]].
  by case: (inv_link I m).
rewrite -(card_uniqP _) ?max_card // map_inj_in_uniq; last first.
  by move=> e f /kn ke /kn kf; exact: (phi_inj I).
rewrite cat_uniq U (inv_uniq I) andbT; apply/hasPn=> e le.
by apply/negP=> /O/andP[_]; rewrite /linked le.
Qed.
(* the paper's per-pass bound: s vertices known, n passes done: s + 2(s-1)(2m-2n) *)
Definition passbound s n := s + 2 * s.-1 * (#|D| - n.*2).
Lemma pass_cost e c C c' n : ok c -> size (links (cS c)) = n.*2 -> pass e c C c' ->
  C <= passbound (size (degs (cS c))) n.
Proof.
move=> Ok sz P; case: P Ok sz => S d p w0 g k.
  move=> h w f ts oe R T sw0 Rj U oh he Rh f0 sw V [r [/= I _ _ _]] sz.
  have H : size (h :: unzip1 ts) <= #|D| - n.*2.
    rewrite -sz leq_subRL; last exact: (size_links I).
    rewrite addnC; apply: (many_open I U) => h'; rewrite inE => /orP[/eqP->//|/mapP[[a z] m /= ->]].
    by case: (Rj a z m).
  rewrite /= size_map in H; rewrite /passbound -addnA leq_add //; first by rewrite addn1.
  apply: (@leq_trans (2 * (size (degs S)).-1 * (size ts).+1)); last by rewrite leq_mul2l H orbT.
  rewrite mulnS addnC leq_add ?(test_cost_le Rj) //.
  rewrite mul2n -addnn (leq_trans _ (leq_addr _ _)) // -ltnS prednK //.
  exact: leq_ltn_trans sw.
move=> ts oe R T sw0 Rj U _ [r [/= I _ _ _]] sz.
have H : size (unzip1 ts) <= #|D| - n.*2.
  rewrite -sz leq_subRL; last exact: (size_links I).
  rewrite addnC; apply: (many_open I U) => h' /mapP[[a z] m /= ->].
  by case: (Rj a z m).
rewrite size_map in H; rewrite /passbound leq_add //; first by rewrite addn1.
by apply: leq_trans (test_cost_le Rj) _; rewrite leq_mul2l H orbT.
Qed.
Definition nv := fcard sigma D.                         (* vertices of the world *)
Lemma size_nv S r : inv S r -> size (degs S) <= nv.
Proof.
move=> I; rewrite (size_r I) /nv /n_comp_mem -(size_map (froot sigma)).
rewrite -(card_uniqP _); last first.
  rewrite map_inj_in_uniq.
    apply/(uniqP d0) => i j; rewrite !inE => li lj E; apply: (inv_sep I) => //.
    by rewrite E connect0.
  move=> x y /(nthP d0)[i li <-] /(nthP d0)[j lj <-] /eqP.
  rewrite (root_connect (fconnect_sym sigma_inj)).
  by move/(inv_sep I) => /(_ li lj) ->.
apply: subset_leq_card; apply/subsetP=> x /mapP[y _ ->].
by rewrite !inE andbT; exact: (roots_root (fconnect_sym sigma_inj)).
Qed.
Definition bound n := \sum_(p < n) passbound (minn p.+1 nv) p.
(* the paper's form, (1) + (2), of the bound for m passes *)
Lemma bound_paper m : 0 < nv -> nv.-1 <= m -> bound m =
  \sum_(1 <= s < nv) (s + 2 * s.-1 * (#|D| - s.-1.*2)) +
  \sum_(0 <= i < m - nv.-1) (nv + 2 * nv.-1 * (#|D| - (i + nv.-1).*2)).
Proof.
move=> n0 le; rewrite /bound -(big_mkord xpredT (fun p => passbound (minn p.+1 nv) p)).
rewrite (big_cat_nat _ (n := nv.-1)) //=; congr (_ + _).
  rewrite -[in RHS](prednK n0) big_add1 /= !big_nat; apply: eq_bigr => p /andP[_ lp].
  by rewrite /passbound (minn_idPl _) // -(prednK n0) ltnS ltnW.
rewrite -{1}[nv.-1]add0n big_addn !big_nat; apply: eq_bigr => i _.
by rewrite /passbound (minn_idPr _) // -{1}(prednK n0) ltnS leq_addl.
Qed.
Lemma passbound_mono s t n : s <= t -> passbound s n <= passbound t n.
Proof.
move=> st; rewrite /passbound leq_add // leq_mul2r leq_mul2l /=.
by rewrite -!subn1 leq_sub2r ?orbT.
Qed.

(* every run, under every choice: at most m passes (2m = #|D|), cost at most the bound,
   never stuck, and right when U is empty *)
Theorem algorithm1 n C c : runs n C c ->
  [/\ n.*2 <= #|D|, C <= bound n,
      forall e, isopen (cS c) e -> exists C1 c', pass e c C1 c' &
      (forall e, ~~ isopen (cS c) e) ->
        exists2 r, iso (cS c) r & known (cS c) (here c) /\ pos c = phi r (here c)].
Proof.
move=> Rn.
have [okc sz _ Cb] : [/\ ok c, size (links (cS c)) = n.*2, size (degs (cS c)) <= n.+1 & C <= bound n].
  elim: Rn => [|m C0 e c1 C1 c2 _ [ok1 s1 d1 Cb] P].
    by split; rewrite ?/bound ?big_ord0 //; exact: ok_start.
  split; first exact: (pass_ok ok1 P).
  - by rewrite (pass_links P) s1 doubleS.
  - exact: leq_trans (pass_size P) _.
  - rewrite /bound big_ord_recr leq_add //=; apply: leq_trans (pass_cost ok1 s1 P) _.
    apply: passbound_mono; rewrite leq_min d1; have [r [I _ _ _]] := ok1; exact: (size_nv I).
split=> //; first by have [r [I _ _ _]] := okc; rewrite -sz; exact: (size_links I).
  by move=> e; exact: progress.
by have [r [I kh ph _]] := okc => nopen; exists r; first exact: (exit_iso I).
Qed.

(* when U is empty exactly m passes were made, and the cost is at most the paper's (1) + (2) *)
Lemma full_links S r : inv S r -> iso S r -> #|D| <= size (links S).
Proof.
move=> I [sur _ _ L _]; rewrite -(size_map fst) -(size_map (phi r)).
apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> d _.
have [e ke <-] := sur d; apply: map_f; have [f [lf _ _]] := L e ke.
by apply/mapP; exists (e, f); rewrite ?linkP.
Qed.
Lemma full_nv S r : inv S r -> iso S r -> nv <= size (degs S).
Proof.
move=> I [sur _ _ _ _]; rewrite (size_r I) -(size_map (froot sigma)) /nv /n_comp_mem.
apply: leq_trans (card_size _); apply: subset_leq_card; apply/subsetP=> x.
rewrite !inE andbT => /eqP rx; have [e ke E] := sur x; have [l1 _] := knownP I ke.
apply/mapP; exists (nth d0 r e.1); first exact: mem_nth.
rewrite -rx; apply/eqP; rewrite (root_connect (fconnect_sym sigma_inj)) (fconnect_sym sigma_inj).
by rewrite -E; exact: phi_conn.
Qed.
Theorem algorithm1_cost n C c : runs n C c -> (forall e, ~~ isopen (cS c) e) ->
  n.*2 = #|D| /\ C <=
  \sum_(1 <= s < nv) (s + 2 * s.-1 * (n.*2 - s.-1.*2)) +
  \sum_(0 <= i < n - nv.-1) (nv + 2 * nv.-1 * (n.*2 - (i + nv.-1).*2)).
Proof.
move=> Rn nopen.
have [okc sz dg] : [/\ ok c, size (links (cS c)) = n.*2 & size (degs (cS c)) <= n.+1].
  elim: Rn {nopen} => [|m C0 e c1 C1 c2 _ [ok1 s1 d1] P].
    by split=> //; exact: ok_start.
  split; first exact: (pass_ok ok1 P).
    by rewrite (pass_links P) s1 doubleS.
  exact: leq_trans (pass_size P) _.
have [r [I _ _ _]] := okc; have X := exit_iso I nopen.
have E : n.*2 = #|D|.
  by apply/eqP; rewrite eqn_leq -sz (size_links I) (full_links I X).
split=> //; have [_ Cb _ _] := algorithm1 Rn; apply: leq_trans Cb _.
have n0 : 0 < nv.
  have [r0 _] := inv_0 I; apply: leq_trans (size_nv I); by rewrite (size_r I).
rewrite E bound_paper // -ltnS (prednK n0); apply: leq_trans dg; exact: (full_nv I X).
Qed.
End World.

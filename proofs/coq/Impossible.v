(* Impossible.v -- no explorer whatever is right on both of two indistinguishable worlds: cycles; the pair of Fig. 1 *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Rooted.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- 1. Cycles of any two lengths; the percept holds the degree and even the dart's compass label ---- *)
Definition cs (d : nat * bool) := (d.1, ~~ d.2).
Definition ca n (d : nat * bool) := (if d.2 then (d.1 + n.-1) %% n else d.1.+1 %% n, ~~ d.2).
Definition cycle n t := @Gmap (nat * bool) (fun d => d.1 < n) cs (ca n) (0, t).
Definition cobs (d : nat * bool) := (2, d.2).
Lemma caK n d : d.1 < n -> ca n (ca n d) = d.
Proof.
case: n => // n; case: d => i [] /= l; rewrite /ca /= ?negbK; congr (_, _).
  by rewrite -addn1 modnDml -addnA addn1 modnDr modn_small.
by rewrite -addn1 modnDml -addnA add1n modnDr modn_small.
Qed.
Lemma cycle_wf n t : 0 < n -> wf (cycle n t).
Proof.
move=> n0; split=> //=.
- by move=> [i b] /=; rewrite /ca /=; case: b; rewrite ltn_mod.
- by move=> [i b] [j c] /= _ _ []; rewrite /cs /= => -> /negb_inj->.
- by move=> d; exact: caK.
- by move=> [i []] /= _ [].
Qed.
Lemma riso_cycle n1 n2 t1 t2 : riso (cycle n1 t1) (cycle n2 t2) -> n1 <= n2.
Proof.
case=> f [g [F G _]]; rewrite /= in F G.
pose L n := [seq (i, c) | i <- iota 0 n, c <- [:: false; true]].
have szL n : size (L n) = n * 2 by rewrite size_allpairs size_iota.
have memL n d : (d \in L n) = (d.1 < n).
  apply/allpairsP/idP=> [[[i c] [/= m _ ->]]|l]; first by rewrite mem_iota in m.
  by exists d; rewrite mem_iota !inE; split=> //; case: (d) => ? []; rewrite ?orbT.
have uL n : uniq (L n) by apply: allpairs_uniq; rewrite ?iota_uniq // => -[a c] [a' c'] _ _ [-> ->].
rewrite -(leq_pmul2r (m := 2)) // -!szL -(size_map f); apply: uniq_leq_size.
  rewrite map_inj_in_uniq // => x y; rewrite !memL => lx ly E'.
  by have [_ <- _ _] := F _ lx; have [_ <- _ _] := F _ ly; rewrite E'.
by move=> y /mapP[x]; rewrite memL => /F[? _ _ _] ->; rewrite memL.
Qed.
Theorem cycles_same_episode E (X : explorer (nat * bool) E) n1 n2 t fuel :
  (@episode _ _ X (cycle n1 t) cobs fuel).1 = (@episode _ _ X (cycle n2 t) cobs fuel).1.
Proof. by apply: (@twins_episode _ _ X (cycle n1 t) (cycle n2 t) cobs cobs (fun x y => x.2 = y.2)) => // x y /= E'; rewrite /cobs E'. Qed.
Theorem cycles_impossible E (dn : E -> gmap) (X : explorer (nat * bool) E) n1 n2 t :
  0 < n1 -> 0 < n2 -> n1 <> n2 ->
  ~ (@right _ _ dn X (cycle n1 t) cobs /\ @right _ _ dn X (cycle n2 t) cobs).
Proof.
move=> p1 p2 ne [r1 r2]; case: ne.
have I : riso (cycle n1 t) (cycle n2 t).
  apply: (@twins_impossible _ _ dn X (cycle n1 t) (cycle n2 t) cobs cobs (fun x y => x.2 = y.2)) => //; try exact: cycle_wf.
  - by move=> x y /= E'; rewrite /cobs E'.
  - by move=> x y /= E'; rewrite E'.
  - by move=> x y /= E'; rewrite E'.
have J := riso_sym (cycle_wf t p1) I.
by apply/eqP; rewrite eqn_leq (riso_cycle I) (riso_cycle J).
Qed.

(* ---- 2. Position only: percept = (degree, am I at the marked vertex?), the marker lies where the robot starts ---- *)
Definition degree M d := let s := nth 0 (rsg M) in (find (fun k => iter k.+1 s d == d) (iota 0 (size (rsg M)))).+1.
Definition marked M d := let s := nth 0 (rsg M) in has (fun k => iter k s d == rrt M) (iota 0 (size (rsg M))).
Definition pobs M d := (degree M d, marked M d).
Definition bisim_check M N (L : seq (nat * nat)) := ((rrt M, rrt N) \in L) &&
  all (fun p => [&& pobs M p.1 == pobs N p.2, (nth 0 (rsg M) p.1, nth 0 (rsg N) p.2) \in L &
                    (nth 0 (ral M) p.1, nth 0 (ral N) p.2) \in L]) L.

(* a certificate: a bisimulation as a list of pairs; different as rooted maps *)
Definition twin_check M N L := [&& valid M, valid N, size (order M) == size (rsg M), bisim_check M N L & ~~ same M N].
Section Certified.
Variables (M N : rmap) (L : seq (nat * nat)).
Hypothesis C : bisim_check M N L.
Let R x y := (x, y) \in L.
Lemma certE x y : R x y -> [/\ pobs M x = pobs N y, R (nth 0 (rsg M) x) (nth 0 (rsg N) y) & R (nth 0 (ral M) x) (nth 0 (ral N) y)].
Proof. by case/andP: C => _ /allP H /H /and3P[/eqP]. Qed.
Theorem certified_episode E (X : explorer (nat * bool) E) fuel :
  (@episode _ _ X (den M) (pobs M) fuel).1 = (@episode _ _ X (den N) (pobs N) fuel).1.
Proof. by apply: (@twins_episode _ _ X (den M) (den N) (pobs M) (pobs N) R); try (by move=> x y /certE[]); case/andP: C. Qed.
End Certified.
Theorem certified_impossible M N L : twin_check M N L ->
  forall E (dn : E -> gmap) (X : explorer (nat * bool) E),
  ~ (@right _ _ dn X (den M) (pobs M) /\ @right _ _ dn X (den N) (pobs N)).
Proof.
case/and5P=> VM VN cM C /negP ns E dn X [r1 r2]; case: ns; apply: same_complete => //.
  exact/connectedP.
by apply: (@twins_impossible _ _ dn X (den M) (den N) (pobs M) (pobs N) (fun x y => (x, y) \in L)) => //;
  try (by move=> x y /(certE C)[]); try exact: validP; case/andP: C.
Qed.

(* worlds from clockwise neighbour lists (simple graphs) *)
Definition of_nbrs (G : seq (seq nat)) :=
  let off v := sumn (take v (map size G)) in
  let darts := flatten [seq [seq (v, i) | i <- iota 0 (size (nth [::] G v))] | v <- iota 0 (size G)] in
  Rmap [seq off d.1 + d.2.+1 %% size (nth [::] G d.1) | d <- darts]
       [seq let w := nth 0 (nth [::] G d.1) d.2 in off w + index d.1 (nth [::] G w) | d <- darts] 0.
(* the relation generated by the two start darts *)
Definition gen M N := let add p l := if p \in l then l else rcons l p in
  let fix go fuel i l := if fuel is f.+1 then if i < size l then let p := nth (0, 0) l i in
    go f i.+1 (add (nth 0 (ral M) p.1, nth 0 (ral N) p.2) (add (nth 0 (rsg M) p.1, nth 0 (rsg N) p.2) l)) else l else l
  in go (size (rsg M) * size (rsg N)) 0 [:: (rrt M, rrt N)].

Definition G1 := of_nbrs [:: [:: 1;2;3;5]; [:: 0;4;6]; [:: 0;6;7]; [:: 0;7;8]; [:: 1;5;6]; [:: 0;8;4]; [:: 2;1;4]; [:: 3;2;8]; [:: 5;3;7]].
Definition G2 := of_nbrs [:: [:: 1;2;3;5]; [:: 0;4;6]; [:: 0;6;4]; [:: 0;7;8]; [:: 1;2;6]; [:: 0;8;7]; [:: 2;1;4]; [:: 3;5;8]; [:: 5;3;7]].
Lemma fig1_check : twin_check G1 G2 (gen G1 G2). Proof. by vm_compute. Qed.
(* for every explorer that senses degree and position only *)
Theorem fig1_impossible E (dn : E -> gmap) (X : explorer (nat * bool) E) :
  ~ (@right _ _ dn X (den G1) (pobs G1) /\ @right _ _ dn X (den G2) (pobs G2)).
Proof. exact: (certified_impossible fig1_check). Qed.
Theorem fig1_same_episode E (X : explorer (nat * bool) E) fuel :
  (@episode _ _ X (den G1) (pobs G1) fuel).1 = (@episode _ _ X (den G2) (pobs G2) fuel).1.
Proof. by apply: (@certified_episode _ _ (gen G1 G2)); vm_compute. Qed.
(* they differ as maps, wherever they are rooted *)
Definition differ_check M N := [&& valid M, size (order M) == size (rsg M) &
  all (fun d => valid (at_ N d) && ~~ same M (at_ N d)) (iota 0 (size (rsg N)))].
Lemma differ M N : differ_check M N -> forall d, d < size (rsg N) -> ~ riso (den M) (den (at_ N d)).
Proof.
case/and3P=> VM cM /allP A d ld I.
have /andP[v /negP ns] := A d (etrans (mem_iota 0 _ d) ld).
by apply: ns; apply: same_complete I => //; exact/connectedP.
Qed.
Lemma fig1_differ : differ_check G1 G2. Proof. by vm_compute. Qed.
Lemma fig1_size : 28 = size (rsg G2). Proof. by vm_compute. Qed.
Theorem fig1_different d : d < 28 -> ~ riso (den G1) (den (at_ G2 d)).
Proof. rewrite {1}fig1_size; exact: (differ fig1_differ). Qed.
(* the caption of Fig. 1: the walk 1,1,2,2,1 senses 3 (four times), then 4 at the marker, in both *)
Definition senses M w d := [seq pobs M (grun (den M) (take k w) d) | k <- iota 1 (size w)].
Arguments senses : clear implicits.
Definition caption M := has (fun k => senses M [:: 1;1;2;2;1] (iter k (nth 0 (rsg M)) 0) ==
  [:: (3, false); (3, false); (3, false); (3, false); (4, true)]) (iota 0 4).
Lemma fig1_caption : caption G1 && caption G2. Proof. by vm_compute. Qed.

(* the smallest pair: one vertex with two loops, on the sphere and on the torus *)
Definition T1 := Rmap [:: 1;2;3;0] [:: 1;0;3;2] 0.
Definition T2 := Rmap [:: 1;2;3;0] [:: 2;3;0;1] 0.
Theorem two_loops_impossible E (dn : E -> gmap) (X : explorer (nat * bool) E) :
  ~ (@right _ _ dn X (den T1) (pobs T1) /\ @right _ _ dn X (den T2) (pobs T2)).
Proof. by apply: (@certified_impossible _ _ (gen T1 T2)); vm_compute. Qed.

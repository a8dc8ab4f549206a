; Uniqueness of the embedded path (key lemma): induction step over the motions
; Says: Two hypotheses with the same motions and the same expected percepts, direction included,
;   are the same dart. Step: true for the motions w, hence for k followed by w.
; Paper: V, step 2 ('Other hypotheses cannot have the same embedded path')
; Symbols:
;   Dart           the darts of the map S (a world is the case in which every dart is explored)
;   Degree         degrees of vertices, compared only
;   turn, back     sigma^k for a fixed k, and its inverse (turns-reversible)
;   explored       the dart's edge is in S
;   partner        the other end of an explored dart
;   degree, home   the percept expected at a dart: degree, and whether the marker is there
;   agree_w        from both darts the motions w lead through S to v0, and all percepts on the way
;                  are equal, the bearing at the end included.  agree_kw: for k followed by w
;   x, y           two hypotheses where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort Degree 0)
(declare-fun turn (Dart) Dart)
(declare-fun back (Dart) Dart)
(declare-fun explored (Dart) Bool)
(declare-fun partner (Dart) Dart)
(declare-fun degree (Dart) Degree)
(declare-fun home (Dart) Bool)
(declare-fun agree_w (Dart Dart) Bool)
(declare-fun agree_kw (Dart Dart) Bool)
(declare-const x Dart)
(declare-const y Dart)

; turning is reversible
(assert (forall ((d Dart)) (= (back (turn d)) d)))
; an explored edge has two ends
(assert (forall ((d Dart)) (=> (explored d) (= (partner (partner d)) d))))
; the same percepts along k followed by w
(assert (forall ((p Dart) (q Dart))
  (= (agree_kw p q)
     (and (= (degree p) (degree q)) (= (home p) (home q))
          (explored (turn p)) (explored (turn q))
          (agree_w (partner (turn p)) (partner (turn q)))))))
; induction hypothesis
(assert (forall ((p Dart) (q Dart)) (=> (agree_w p q) (= p q))))
; two hypotheses with the same motions and percepts
(assert (agree_kw x y))

; not: the same dart
(assert (not (= x y)))
(check-sat)

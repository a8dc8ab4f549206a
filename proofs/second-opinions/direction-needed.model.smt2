; A model of the hypotheses of direction-needed.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. The marker points to a0; S has a0b0 and a1c0; the hypotheses are b1 and c1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun degree ((x Dart)) Degree two)
(define-fun home ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun explored ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun pointed () Dart a0)
(define-fun x () Dart b1)
(define-fun y () Dart c1)

(assert (forall ((d Dart)) (or (= d a0) (= d a1) (= d b0) (= d b1) (= d c0) (= d c1))))
(assert (forall ((d Dart)) (and (= (sigma (sigma d)) d) (not (= (sigma d) d)))))
(assert (forall ((d Dart)) (and (= (alpha (alpha d)) d) (not (= (alpha d) d)))))
(assert (forall ((d Dart))
  (and (= (degree (sigma d)) (degree d)) (= (home (sigma d)) (home d)))))
(assert (home pointed))
(assert (forall ((d Dart)) (=> (home d) (or (= d pointed) (= d (sigma pointed))))))
(assert (forall ((d Dart)) (=> (explored d) (explored (alpha d)))))
(assert (not (explored x)))
(assert (not (explored y)))
(assert (explored (sigma x)))
(assert (explored (sigma y)))
(assert (and (= (degree x) (degree y)) (not (home x)) (not (home y))))
(assert (and (home (alpha (sigma x))) (home (alpha (sigma y)))))
(assert (not (= x y)))
(assert (and (= (alpha (sigma x)) pointed) (not (= (alpha (sigma y)) pointed))))
(check-sat)

; A model of the hypotheses of key-lemma-step.smt2
; Says: Of a triangle S knows the three vertices and the edges a0b0, a1c0; b1 and c1 are open. k =
;   1, w is empty; x = y = c1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun turn ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun back ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun explored ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun partner ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun degree ((x Dart)) Degree two)
(define-fun home ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun agree_w ((x0 Dart) (x1 Dart)) Bool
  (or (and (= x0 a0) (= x1 a0)) (and (= x0 a1) (= x1 a1))))
(define-fun agree_kw ((x0 Dart) (x1 Dart)) Bool
  (or (and (= x0 b1) (= x1 b1)) (and (= x0 c1) (= x1 c1))))
(define-fun x () Dart c1)
(define-fun y () Dart c1)

(assert (forall ((d Dart)) (= (back (turn d)) d)))
(assert (forall ((d Dart)) (=> (explored d) (= (partner (partner d)) d))))
(assert (forall ((p Dart) (q Dart))
  (= (agree_kw p q)
     (and (= (degree p) (degree q)) (= (home p) (home q))
          (explored (turn p)) (explored (turn q))
          (agree_w (partner (turn p)) (partner (turn q)))))))
(assert (forall ((p Dart) (q Dart)) (=> (agree_w p q) (= p q))))
(assert (agree_kw x y))
(check-sat)

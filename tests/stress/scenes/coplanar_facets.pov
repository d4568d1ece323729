#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.4,0.3,-5.0> direction <-0.06851585941627233,-0.06851585941627233,1.3703171883254466> right <0.9987523388778446,0.0,0.04993761694389224> up <-0.0024906619562249615,0.9987554444462093,0.049813239124499226>}
triangle{<-1.5,-1.1,-0.35>,<1.3,-0.7,-0.81>,<0.1,1.3,-0.02> pigment{rgb 1} finish{ambient 0 emission 0.9 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
triangle{<-1.4,0.9,0.1757236842105263>,<0.3,-1.2,-0.7432236842105264>,<1.5,1.1,-0.35921052631578954> pigment{rgb 1} finish{ambient 0 emission 0.3 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}

#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.1}
camera{perspective location <3e-06,4.000000000000001e-06,-6.000000000000001e-05> direction <-0.07444770310441474,-0.1116715546566221,1.8611925776103684> right <0.9992009587217895,0.0,0.03996803834887158> up <-0.002391871498609874,0.9982077054198542,0.059796787465246845>}
box{<-1e-05,-1e-05,1e-05>,<1e-05,1e-05,-1e-05> pigment{rgbf<1,1,1,1>} finish{ambient 0 emission 0.0 diffuse 0.0 specular 0 phong 0 reflection{0.0} } interior{ior 1.3}}
sphere{<1.0000000000000002e-06,5.000000000000001e-07,-2.0000000000000003e-06>,6e-06 pigment{rgbf<1,1,1,1>} finish{ambient 0 emission 0.0 diffuse 0.0 specular 0 phong 0 reflection{0.0} } interior{ior 1.6}}
plane{<0.3,0.2,1.0>,6.500000000000001e-05 pigment{rgb 1} finish{ambient 0 emission 0.8 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
sphere{<5e-06,4.000000000000001e-06,4e-05>,1.2e-05 pigment{rgb 1} finish{ambient 0 emission 0.3 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}

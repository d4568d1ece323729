#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 200 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.0,0.0,0.5> direction <0.07795789958253038,0.0,3.999240248583808> right <0.999810062145952,-0.0,-0.019489474895632596> up <0.0,1.0,0.0>}
plane{<0.0,0.0,1.0>,0.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.0 specular 0 phong 0 reflection{0.99} }}
plane{<0.0,0.0,1.0>,1.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.0 specular 0 phong 0 reflection{0.99} }}
plane{<1.0,0.0,0.0>,1.0 pigment{rgb 1} finish{ambient 0 emission 1.0 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
plane{<1.0,0.0,0.0>,-1.0 pigment{rgb 1} finish{ambient 0 emission 0.5 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
sphere{<0.5,0.02,0.4>,0.1 pigment{rgb 1} finish{ambient 0 emission 0.7 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}

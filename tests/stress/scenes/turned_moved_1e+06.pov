#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <1000000.0,-749998.5,499994.0> direction <0.0,0.0,1.5> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
light_source{<999996.0,-749994.0,499995.0> rgb 1}
plane{<0.0,1.0,0.0>,-750000.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
sphere{<1000000.0,-749999.0,500000.0>,1.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
box{<-0.5,-0.5,0.5>,<0.5,0.5,-0.5> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0> translate <1000001.9,-749999.0,499999.5>}
triangle{<999997.0,-750000.0,500001.0>,<999999.0,-750000.0,500002.0>,<999998.0,-749997.5,500001.5> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}

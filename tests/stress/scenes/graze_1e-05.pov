#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.0,1.5,-6.0> direction <0.0,0.0,1.5> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
light_source{<-1000.0,0.01,-300.0> rgb 1}
plane{<0.0,1.0,0.0>,0.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 100000.0 specular 0 phong 0 reflection{0.0} }}
sphere{<0.0,1.0,0.0>,1.0 pigment{rgb 1} finish{ambient 0 emission 0.5 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}

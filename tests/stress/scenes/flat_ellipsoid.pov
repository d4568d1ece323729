#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.5,2.0,-6.0> direction <0.0,-0.2037810224087592,1.358540149391728> right <1.0,-0.0,0.0> up <0.0,0.9889363528682975,0.14834045293024462>}
light_source{<-2.0,6.0,-3.0> rgb 1}
plane{<0.0,1.0,0.0>,0.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
sphere{<0.0,0.0,0.0>,1.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.8 specular 0 phong 0 reflection{0.0} } scale <1.0,0.0001,0.7> rotate <-20.0,-0.0,30.0> translate <0.3,1.2,0.0>}

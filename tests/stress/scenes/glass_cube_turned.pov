#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.1}
camera{perspective location <0.0,0.0,-4.0> direction <0.0,0.0,1.8660254037844388> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
box{<-0.7,-0.6,0.5>,<0.7,0.6,-0.5> pigment{rgbf<1,1,1,1>} finish{ambient 0 emission 0.0 diffuse 0.0 specular 0 phong 0 reflection{0.0} } interior{ior 1.5} rotate <-31.0,-17.0,53.0>}
plane{<0.3,0.2,1.0>,6.5 pigment{rgb 1} finish{ambient 0 emission 0.8 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
sphere{<0.3,0.2,3.0>,0.9 pigment{rgb 1} finish{ambient 0 emission 0.3 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}
sphere{<-1.3,0.9,4.0>,0.8 pigment{rgb 1} finish{ambient 0 emission 0.5 diffuse 0.0 specular 0 phong 0 reflection{0.0} }}

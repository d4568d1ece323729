#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.0,0.0,-10000000.0> direction <0.0,0.0,3571428.571428572> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
light_source{<3.0,4.0,-5.0> rgb 1}
box{<-0.7,-0.6,0.5>,<0.7,0.6,-0.5> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0>}
